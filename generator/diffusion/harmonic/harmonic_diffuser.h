// True diffusion: Laplace's equation in the volume, solved on a grid (what the paper, section 3.2, held to be too
// dear).
#pragma once

#include "generator/diffusion/diffuser.h"

namespace pomona {

struct HarmonicOptions {
  Quality quality = Quality::final;
  Threads threads{};

  /// Nodes along the side of a cube as large as the surfaces' box; 0 lets the quality choose.
  int nodes = 0;
  int cycles = 0;       ///< of the multigrid on the finest level; 0 lets the quality choose
  int finer = -1;       ///< how often patches halve the spacing, at most; -1: as needed
  double bend = -1;     ///< see GridOptions; -1: as the quality says, which is 0 but for reference
  glm::dvec3 shift{0};  ///< moves the grid by parts of a cell: what tests vary
};

/// The harmonic function with the colours of the surfaces' sides as its values there; where a random walk may escape
/// to infinity without meeting a surface, its mean over the walks that do not. Same bits for any number of threads
/// and on any x86-64. Outside surfaces that seal everything off, the nearest side gives the colour.
std::unique_ptr<Diffuser> make_harmonic_diffuser(const HarmonicOptions& options = {});

}  // namespace pomona
