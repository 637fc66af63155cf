#include "generator/diffusion/harmonic/grid_options.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/diffusion/harmonic/lattice.h"

namespace pomona {

namespace {

/// A point nearer than this to a surface, in parts of the surfaces' size, may be on it.
constexpr double near_surface = 2e-5;

/// Patches may halve the spacing so often; their limit in memory may stop them sooner.
constexpr int max_halvings = 2;

struct Effort {
  int nodes;  ///< along the side of a cube as large as the surfaces' box
  int cycles;
  double refine_above = GridOptions{}.refine_above;
  std::size_t max_patch_nodes = GridOptions{}.max_patch_nodes;
};

/// Measured in docs/reports/diffusion.md. Patches where the solution bends take three times as long as all else, and
/// pages, whose look-up is held to the field of `final`, carry none.
Effort effort_for(Quality quality) {
  if (quality == Quality::draft) return {64, 1};
  if (quality == Quality::final) return {112, 1};
  return {140, 3, 8.0 / 255, 6'000'000};
}

/// That of `nodes` cubed nodes in the box, so that long and flat fruits get as many as round ones; no longer side
/// has more than a lattice can count.
double spacing_in(const glm::dvec3& extent, int nodes) {
  const double longest = std::max({extent.x, extent.y, extent.z});
  const glm::dvec3 thick = glm::max(extent, glm::dvec3(longest / 16));
  const double even = reproducible::cbrt(thick.x * thick.y * thick.z) / std::max(nodes, 4);
  return std::max(even, longest / max_cells);
}

}  // namespace

GridOptions grid_options(const DiffusionSurfaces& surfaces, const HarmonicOptions& options) {
  const Effort effort = effort_for(options.quality);
  const glm::dvec3 extent = bounds_of(surfaces).size();
  return {.spacing = spacing_in(extent, options.nodes > 0 ? options.nodes : effort.nodes),
          .cycles = options.cycles > 0 ? options.cycles : effort.cycles,
          .shift = options.shift,
          .finer = options.finer >= 0 ? options.finer : max_halvings,
          .refine_above = options.refine_above >= 0 ? options.refine_above : effort.refine_above,
          .max_patch_nodes = effort.max_patch_nodes,
          .reach = near_surface * glm::length(extent),
          .threads = options.threads};
}

}  // namespace pomona
