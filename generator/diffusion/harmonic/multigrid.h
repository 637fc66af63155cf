// Solves Laplace's equation on a grid with cut links by going through coarser and coarser ones.
#pragma once

#include <vector>

#include "generator/base/parallel.h"
#include "generator/diffusion/harmonic/grid_level.h"

namespace pomona {

struct MultigridOptions {
  int sweeps = 2;  ///< before and after each correction
  int cycles = 1;  ///< on the finest level, from the interpolated solution of the next
  Threads threads;
};

/// Full multigrid with V cycles: levels.front().value becomes the solution. Coarse links inherit the cuts of fine ones,
/// and nothing is ever interpolated across a surface. Same bits for any number of threads.
std::vector<GridLevel> solved(std::vector<GridLevel> levels, const MultigridOptions& options);

/// The same where the levels from `known` on hold their solution already, found without the finer ones.
std::vector<GridLevel> solved_further(std::vector<GridLevel> levels, std::size_t known,
                                      const MultigridOptions& options);

}  // namespace pomona
