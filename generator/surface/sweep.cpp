#include "generator/surface/sweep.h"

#include "generator/surface/grid_painter.h"
#include "generator/surface/swept_grid.h"

namespace pomona {

DiffusionSurfaces sweep(const Template& fruit, const SweepOptions& options) {
  DiffusionSurfaces surfaces;
  surfaces.part_names = fruit.parts;
  for (const SurfaceSketch& sketch : fruit.surfaces) {
    GridPainter painter(surfaces, sketch.name, sketch.front, sketch.back, sketch.blur);
    for (const SweptGrid& grid : swept_grids(fruit, sketch, options)) painter.append(grid);
  }
  return surfaces;
}

}  // namespace pomona
