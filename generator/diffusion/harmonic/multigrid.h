// Multigrid: solves Laplace's equation on a grid with cut arms with the help of coarser and coarser grids.
#pragma once

#include <vector>

#include "generator/base/parallel.h"
#include "generator/diffusion/harmonic/grid_level.h"

namespace pomona {

struct MultigridOptions {
  int sweeps = 2;  ///< Gauss-Seidel sweeps before and after each correction
  int cycles = 1;  ///< V cycles on the finest level; they start from the interpolated solution of the next level
  Threads threads;
};

/// Full multigrid with V cycles. levels.front().value becomes the solution. Coarse arms inherit the cuts of fine arms,
/// and no value is interpolated across a surface. The result has the same bits for any number of threads.
std::vector<GridLevel> solved(std::vector<GridLevel> levels, const MultigridOptions& options);

/// The same where the levels from index `known` on already hold their solution, found without the finer levels.
std::vector<GridLevel> solved_further(std::vector<GridLevel> levels, std::size_t known,
                                      const MultigridOptions& options);

}  // namespace pomona
