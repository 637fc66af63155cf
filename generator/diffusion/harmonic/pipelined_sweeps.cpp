#include "generator/diffusion/harmonic/pipelined_sweeps.h"

#include <algorithm>

namespace pomona {

namespace {

/// A level with fewer blocks than this is too small to share between threads.
constexpr std::size_t runs_worth_sharing = 1000;

/// A level with more blocks than this does not fit into the cache: a block has 128 bytes, and its stencils.
constexpr std::size_t runs_beyond_cache = 30000;

/// This many slabs with about equal numbers of blocks; none if one would be too thin for `steps` steps.
std::vector<PlaneSlab> stacks_of(const GridLevel& level, int steps, std::size_t parts) {
  std::vector<PlaneSlab> slabs;
  std::size_t blocks = 0;
  int first = 0;
  for (int p = 0; p < static_cast<int>(level.planes.size()); ++p) {
    blocks += level.planes[static_cast<std::size_t>(p)].second - level.planes[static_cast<std::size_t>(p)].first;
    if (blocks * parts < level.blocks.size() * (slabs.size() + 1)) continue;
    if (p + 1 - first < 2 * steps) return {};
    slabs.push_back({first, p + 1});
    first = p + 1;
  }
  return slabs;
}

}  // namespace

Threads threads_for(const GridLevel& level, Threads threads) {
  return {level.blocks.size() < runs_worth_sharing ? 1 : threads.count};
}

std::vector<PlaneSlab> slabs_for(const GridLevel& level, int steps, Threads threads) {
  if (level.blocks.size() < runs_beyond_cache) return {};
  const auto max = static_cast<std::size_t>(std::min(resolved(threads), max_threads));
  if (max == 1) return stacks_of(level, steps, 1);
  for (const std::size_t to_a_thread : {4, 2, 1}) {
    std::vector<PlaneSlab> slabs = stacks_of(level, steps, to_a_thread * max);
    if (!slabs.empty()) return slabs;
  }
  return {};
}

}  // namespace pomona
