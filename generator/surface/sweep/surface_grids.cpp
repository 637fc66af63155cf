#include "generator/surface/sweep/surface_grids.h"

#include <algorithm>
#include <utility>

#include "generator/surface/sweep/body_map.h"
#include "generator/surface/sweep/cells.h"

namespace pomona {

namespace {

/// The grids in the fruit's proportions, and bent with it.
std::vector<SweptGrid> in_place(const Template& fruit, std::vector<SweptGrid> grids) {
  const BodyMap map(fruit);
  if (map.is_identity()) return grids;
  for (SweptGrid& grid : grids) {
    for (glm::dvec3& p : grid.position) p = map(p);
  }
  return grids;
}

/// Variants may lack a surface (variation/vary_counts.h): its loops are there, but empty.
bool is_left_out(const SurfaceSketch& sketch) {
  const auto is_empty = [](const Curve& loop) { return loop.points.empty(); };
  return sketch.reference && std::all_of(sketch.horizontal.begin(), sketch.horizontal.end(), is_empty);
}

}  // namespace

std::vector<SweptGrid> swept_grids(const Template& fruit, const SurfaceSketch& sketch, const SweepOptions& options) {
  // Two poles and a ring between them at least.
  const int around = refined(sketch.around, options.detail, 3);
  const int along = refined(sketch.along, options.detail, 3);
  if (static_cast<double>(around) * along > 4e6) {
    refuse(fruit, sketch, "more than 4 million vertices", "lower around or along");
  }
  if (sketch.vertical.points.size() < (sketch.vertical.closed ? 3u : 2u) || !(length(sketch.vertical) > 0)) {
    refuse(fruit, sketch, "the vertical curve has no length", "draw it from the surface's bottom to its top");
  }
  if (is_left_out(sketch)) return {};
  if (sketch.type == SurfaceType::in_fold) return in_place(fruit, swept_in_folds(fruit, sketch, around, along));
  std::vector<SweptGrid> grids = in_place(fruit, {swept_around_axis(fruit, sketch, around, along)});
  if (sketch.front.cells || sketch.back.cells)
    grids.front() = with_cells(std::move(grids.front()), fruit, sketch, options.key);
  return grids;
}

}  // namespace pomona
