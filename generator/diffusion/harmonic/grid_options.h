// Options of the grid and of its solution.
#pragma once

#include <cstddef>

#include <glm/vec3.hpp>

#include "generator/base/parallel.h"
#include "generator/diffusion/harmonic/harmonic_options.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

struct GridOptions {
  double spacing = 0;   ///< metres between nodes
  int cycles = 1;       ///< see MultigridOptions
  glm::dvec3 shift{0};  ///< shift of the grid, in cells
  int finer = 0;        ///< how many times patches may halve the spacing
  double refine_above =
      0;  ///< how much of full colour, at the least (refinement_indicator.h); 0: patches lie around small bodies only
  std::size_t max_patch_nodes = 1'000'000;  ///< limit of nodes in each patch; a node takes some 60 bytes
  double reach = 0;                         ///< metres: a surface this near to a cell counts as in it
  Threads threads;
};

/// The options for a quality, around these surfaces.
GridOptions grid_options(const DiffusionSurfaces& surfaces, const HarmonicOptions& options);

}  // namespace pomona
