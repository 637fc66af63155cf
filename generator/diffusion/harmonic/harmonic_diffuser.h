// True diffusion: Laplace's equation in the volume, solved on a grid. The paper (section 3.2) avoids it as too slow.
#pragma once

#include "generator/diffusion/diffuser.h"

namespace pomona {

struct HarmonicOptions {
  Quality quality = Quality::final;
  Threads threads{};

  /// Nodes along the side of a cube as large as the surfaces' box; 0 lets the quality choose.
  int nodes = 0;
  int cycles = 0;            ///< of the multigrid on the finest level; 0 lets the quality choose
  int finer = -1;            ///< how many times patches may halve the spacing; -1 = as needed
  double refine_above = -1;  ///< see GridOptions; -1 lets the quality choose: 0, except for reference
  glm::dvec3 shift{0};       ///< moves the grid, in cells; tests vary it
};

/// The harmonic function whose values on the surfaces are the colours of their sides. Where a random walk may escape to
/// infinity without meeting a surface, it is the mean over the walks that do not escape. The result has the same bits
/// for any number of threads and on any x86-64. Outside closed surfaces, the nearest side gives the colour.
std::unique_ptr<Diffuser> make_harmonic_diffuser(const HarmonicOptions& options = {});

}  // namespace pomona
