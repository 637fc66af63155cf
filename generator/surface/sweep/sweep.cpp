#include "generator/surface/sweep/sweep.h"

#include "generator/surface/sweep/grid_painter.h"
#include "generator/surface/sweep/mesh_surfaces.h"
#include "generator/surface/sweep/spots.h"
#include "generator/surface/sweep/swept_grid.h"

namespace pomona {

DiffusionSurfaces sweep(const Template& fruit, const SweepOptions& options) {
  DiffusionSurfaces surfaces;
  surfaces.part_names = fruit.parts;
  for (const SurfaceSketch& sketch : fruit.surfaces) {
    GridPainter painter(surfaces, sketch.name, sketch.front, sketch.back, sketch.blur);
    const std::vector<SweptGrid> grids = swept_grids(fruit, sketch, options);
    for (const SweptGrid& grid : grids) painter.append(grid);
    for (const SideOf side : {SideOf::front, SideOf::back}) {
      painter.dab(side, placed_spots(fruit, sketch, side, grids, options), grids);
    }
  }
  const std::size_t drawn = surfaces.triangle_count();
  for (const MeshSketch& mesh : fruit.meshes) {
    surfaces = joined(surfaces, mesh_surfaces(fruit, mesh));
    check_meshes_together(fruit, mesh, surfaces.triangle_count() - drawn);
  }
  return surfaces;
}

}  // namespace pomona
