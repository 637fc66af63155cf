#include "generator/diffusion/harmonic/solve_field.h"

#include <utility>
#include <vector>

#include "generator/diffusion/harmonic/exterior.h"
#include "generator/diffusion/harmonic/multigrid.h"

namespace pomona {

namespace {

/// Times that the grid is halved for the multigrid.
constexpr int halvings = 4;

/// Cells around the surfaces: enough for a flood to pass.
constexpr int margin = 1;

std::vector<GridLevel> make_levels(const SnappedSurfaces& snapped, const Lattice& lattice, Threads threads) {
  // All links first; then only what the outside is not.
  const NodeRuns all = all_node_runs(lattice.count);
  const CutLinks links = make_cut_links(snapped, lattice, all, threads);
  auto [runs, kept] = without(all, links, sealed_off(links, all, snapped.surfaces->triangle_count()));

  const glm::dvec3 middle = bounds_of(*snapped.surfaces).center();
  std::vector<GridLevel> levels;
  levels.push_back(make_grid_level(lattice, std::move(runs), std::move(kept), middle, threads));
  for (int i = 0; i < halvings; ++i) levels.push_back(coarser(levels.back(), middle, threads));
  return levels;
}

}  // namespace

FieldLookUp solved_field(const DiffusionSurfaces& surfaces, const GridOptions& options) {
  const Lattice lattice = lattice_around(surfaces, options.spacing, margin, halvings, options.shift);
  const SnappedSurfaces snap = snapped(surfaces, lattice);
  CellTriangles triangles(snap, lattice, options.reach / lattice.spacing, options.threads);
  std::vector<GridLevel> levels =
      solved(make_levels(snap, lattice, options.threads), {.cycles = options.cycles, .threads = options.threads});
  GridLevel& finest = levels.front();
  return {snap, {finest.lattice, std::move(finest.runs), std::move(finest.value)}, std::move(triangles)};
}

}  // namespace pomona
