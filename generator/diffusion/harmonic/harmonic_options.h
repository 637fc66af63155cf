// How finely true diffusion is solved.
#pragma once

#include <glm/vec3.hpp>

#include "generator/base/parallel.h"
#include "generator/diffusion/quality.h"

namespace pomona {

struct HarmonicOptions {
  Quality quality = Quality::final;
  Threads threads{};

  /// Nodes along the side of a cube as large as the surfaces' box; 0 lets the quality choose.
  int nodes = 0;
  int cycles = 0;            ///< multigrid cycles on the finest level; 0 lets the quality choose
  int finer = -1;            ///< how often patches halve the spacing, at most; -1: as needed
  double refine_above = -1;  ///< see GridOptions; -1 lets the quality choose: 0, except for reference
  glm::dvec3 shift{0};       ///< moves the grid by parts of a cell; tests vary it
};

}  // namespace pomona
