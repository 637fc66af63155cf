#include "generator/diffusion/harmonic/grid_options.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "generator/diffusion/harmonic/lattice.h"

namespace pomona {

namespace {

/// A point nearer than this to a surface, in parts of the surfaces' size, may be on it.
constexpr double near_surface = 2e-5;

/// Patches may halve the spacing so often; their limit in memory may stop them sooner.
constexpr int most_halvings = 2;

struct Effort {
  int nodes, cycles;
};

/// Measured in docs/diffusion.md.
Effort effort_for(Quality quality) {
  if (quality == Quality::draft) return {64, 1};
  if (quality == Quality::final) return {104, 1};
  return {192, 3};
}

}  // namespace

GridOptions grid_options(const DiffusionSurfaces& surfaces, const HarmonicOptions& options) {
  const Effort effort = effort_for(options.quality);
  const int nodes = std::clamp(options.nodes > 0 ? options.nodes : effort.nodes, 4, most_cells / 2);
  const glm::dvec3 extent = bounds_of(surfaces).size();
  return {.spacing = std::max({extent.x, extent.y, extent.z}) / nodes,
          .cycles = options.cycles > 0 ? options.cycles : effort.cycles,
          .shift = options.shift,
          .finer = options.finer >= 0 ? options.finer : most_halvings,
          .reach = near_surface * glm::length(extent),
          .threads = options.threads};
}

}  // namespace pomona
