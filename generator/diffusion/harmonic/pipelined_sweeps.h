// Pipelined sweeps: several steps of work over the planes of a level. If the level does not fit into the cache, the
// steps follow close behind each other through slabs of planes; else each step goes through all planes before the next.
#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/diffusion/harmonic/grid_level.h"

namespace pomona {

/// Planes that one thread works on.
struct PlaneSlab {
  int first = 0;  ///< index of its first plane in GridLevel::planes
  int end = 0;    ///< index of the plane after its last one
};

/// The number of threads for a level: one if the level is too small to share.
Threads threads_for(const GridLevel& level, Threads threads);

/// Slabs for a level: four for each thread, so that the threads finish at about the same time; fewer if slabs would be
/// too thin for `steps` steps; none if the level fits into the cache.
std::vector<PlaneSlab> slabs_for(const GridLevel& level, int steps, Threads threads);

/// In each slab, the steps follow each other from plane to plane, while the planes are in the cache. The planes near a
/// border between two slabs must wait for both: the thread that finishes the second slab does them.
template <typename Body>
void sweep_in_slabs(const GridLevel& level, const std::vector<PlaneSlab>& slabs, int steps, Threads threads,
                    const Body& body) {
  const auto take = [&](int plane, int step) {
    const auto [first, end] = level.planes[static_cast<std::size_t>(plane)];
    body(first, end, step);
  };
  const auto sweep_slab = [&](std::size_t i) {
    const bool is_first = i == 0, is_last = i + 1 == slabs.size();
    for (int front = slabs[i].first; front < slabs[i].end + steps - 1; ++front) {
      for (int step = 0; step < steps; ++step) {
        const int plane = front - step;
        const int low = slabs[i].first + (is_first ? 0 : step), end = slabs[i].end - (is_last ? 0 : step);
        if (plane >= low && plane < end) take(plane, step);
      }
    }
  };
  const auto sweep_border = [&](int border) {
    for (int step = 1; step < steps; ++step) {
      for (int plane = border - step; plane < border + step; ++plane) take(plane, step);
    }
  };
  std::vector<std::atomic<int>> slabs_done(slabs.size() + 1);  // next to border i, which is below slab i
  parallel_for(slabs.size(), threads, [&](std::size_t i) {
    sweep_slab(i);
    if (i > 0 && ++slabs_done[i] == 2) sweep_border(slabs[i].first);
    if (i + 1 < slabs.size() && ++slabs_done[i + 1] == 2) sweep_border(slabs[i].end);
  });
}

/// Calls body(first block, end, step) for all planes and steps. A step runs on a plane when the step before is done on
/// that plane and on its two neighbours, and the step after has not begun on any of them. The result is that of steps
/// one after the other over the whole level, if a step never reads on a neighbour plane what the same step writes.
template <typename Body>
void sweep_planes(const GridLevel& level, int steps, Threads threads, const Body& body) {
  const std::vector<PlaneSlab> slabs = slabs_for(level, steps, threads);
  if (!slabs.empty()) {
    sweep_in_slabs(level, slabs, steps, threads, body);
    return;
  }
  for (int step = 0; step < steps; ++step) {
    parallel_for(level.planes.size(), threads_for(level, threads),
                 [&](std::size_t p) { body(level.planes[p].first, level.planes[p].second, step); });
  }
}

}  // namespace pomona
