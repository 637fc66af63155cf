// How fine a grid is, and how long it is worked on.
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
  glm::dvec3 shift{0};  ///< of the grid, in cells
  int finer = 0;        ///< how often patches may halve the spacing, around small bodies and where the solution bends
  double bend = 0;      ///< how much of full colour, at the least (bends.h); 0: patches lie around small bodies only
  std::size_t most_patch_nodes = 1'000'000;  ///< of each patch: with all that belongs to them, some 60 bytes a node
  double reach = 0;                          ///< metres: surfaces this near to a cell count as in it
  Threads threads;
};

/// What a quality stands for, around these surfaces.
GridOptions grid_options(const DiffusionSurfaces& surfaces, const HarmonicOptions& options);

}  // namespace pomona
