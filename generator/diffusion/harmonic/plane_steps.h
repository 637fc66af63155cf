// How several steps of work go through the planes of a grid's level: one after the other through all of it, or, where
// it does not stay in the cache, close behind each other through stacks of planes.
#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/diffusion/harmonic/grid_level.h"

namespace pomona {

/// Planes that one thread works on, by their places in GridLevel::planes.
struct Stack {
  int first = 0, end = 0;
};

/// One for levels that are too small to share.
Threads threads_for(const GridLevel& level, Threads threads);

/// Four stacks to a thread, so that threads are done at about the same time, or fewer if these would be too thin to
/// take `steps` steps in; none if the level is so small that it stays in the cache from step to step anyway.
std::vector<Stack> stacks_for(const GridLevel& level, int steps, Threads threads);

/// Steps follow each other from plane to plane through a stack, as long as the planes are in the cache. Near a border
/// they must wait for both its stacks: whoever is done with the second of them goes on there.
template <typename Body>
void run_in_stacks(const GridLevel& level, const std::vector<Stack>& stacks, int steps, Threads threads,
                   const Body& body) {
  const auto take = [&](int plane, int step) {
    const auto [first, end] = level.planes[static_cast<std::size_t>(plane)];
    body(first, end, step);
  };
  const auto take_stack = [&](std::size_t i) {
    const bool is_first = i == 0, is_last = i + 1 == stacks.size();
    for (int front = stacks[i].first; front < stacks[i].end + steps - 1; ++front) {
      for (int step = 0; step < steps; ++step) {
        const int plane = front - step;
        const int low = stacks[i].first + (is_first ? 0 : step), end = stacks[i].end - (is_last ? 0 : step);
        if (plane >= low && plane < end) take(plane, step);
      }
    }
  };
  const auto take_border = [&](int border) {
    for (int step = 1; step < steps; ++step) {
      for (int plane = border - step; plane < border + step; ++plane) take(plane, step);
    }
  };
  std::vector<std::atomic<int>> stacks_done(stacks.size() + 1);  // beside border i, which is below stack i
  parallel_for(stacks.size(), threads, [&](std::size_t i) {
    take_stack(i);
    if (i > 0 && ++stacks_done[i] == 2) take_border(stacks[i].first);
    if (i + 1 < stacks.size() && ++stacks_done[i + 1] == 2) take_border(stacks[i].end);
  });
}

/// Calls body(first run, end, step) for all planes and steps, each step on a plane when the one before is done there
/// and on both planes beside, and the one after on none of these. That is as good as each step on all planes at once if
/// what a step reads beside its plane is never what the same step writes.
template <typename Body>
void take_steps(const GridLevel& level, int steps, Threads threads, const Body& body) {
  const std::vector<Stack> stacks = stacks_for(level, steps, threads);
  if (!stacks.empty()) {
    run_in_stacks(level, stacks, steps, threads, body);
    return;
  }
  for (int step = 0; step < steps; ++step) {
    parallel_for(level.planes.size(), threads_for(level, threads),
                 [&](std::size_t p) { body(level.planes[p].first, level.planes[p].second, step); });
  }
}

}  // namespace pomona
