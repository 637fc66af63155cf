#include "generator/diffusion/harmonic/plane_steps.h"

#include <algorithm>

namespace pomona {

namespace {

/// Levels with fewer runs are too small to share.
constexpr std::size_t runs_worth_sharing = 1000;

/// Levels with more do not stay in the cache between one sweep and the next: a run has 128 bytes, and its stencils.
constexpr std::size_t runs_beyond_cache = 30000;

/// So many stacks of planes with about as many runs each; none if one would be too thin to take `steps` steps in it.
std::vector<Stack> stacks_of(const GridLevel& level, int steps, std::size_t parts) {
  std::vector<Stack> stacks;
  std::size_t runs = 0;
  int first = 0;
  for (int p = 0; p < static_cast<int>(level.planes.size()); ++p) {
    runs += level.planes[static_cast<std::size_t>(p)].second - level.planes[static_cast<std::size_t>(p)].first;
    if (runs * parts < level.runs.size() * (stacks.size() + 1)) continue;
    if (p + 1 - first < 2 * steps) return {};
    stacks.push_back({first, p + 1});
    first = p + 1;
  }
  return stacks;
}

}  // namespace

Threads threads_for(const GridLevel& level, Threads threads) {
  return {level.runs.size() < runs_worth_sharing ? 1 : threads.count};
}

std::vector<Stack> stacks_for(const GridLevel& level, int steps, Threads threads) {
  if (level.runs.size() < runs_beyond_cache) return {};
  const auto most = static_cast<std::size_t>(std::min(resolved(threads), most_threads));
  if (most == 1) return stacks_of(level, steps, 1);
  for (const std::size_t to_a_thread : {4, 2, 1}) {
    std::vector<Stack> stacks = stacks_of(level, steps, to_a_thread * most);
    if (!stacks.empty()) return stacks;
  }
  return {};
}

}  // namespace pomona
