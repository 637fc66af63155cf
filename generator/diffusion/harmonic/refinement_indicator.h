// The refinement indicator: where a solved grid is too coarse for its own solution.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/diffusion/harmonic/grid_level.h"

namespace pomona {

/// The indicator of a solved node: along each axis, how far its value is from the straight line between the ends of its
/// two arms; the largest over axes and channels (1 = full colour). The error of a value interpolated between nodes is
/// about a quarter of it.
float indicator_at(const GridLevel& level, std::size_t block, int k);

/// For each brick of a level's lattice (patches.h): the largest indicator of the nodes that it touches, or 0 where that
/// is below `threshold`. The result is the same for any number of threads.
std::vector<float> indicator_of_bricks(const GridLevel& level, double threshold, Threads threads);

/// Marks the bricks with an indicator above 0; if these are more than `max_bricks`, only those with the largest.
std::vector<std::uint8_t> bricks_to_refine(const std::vector<float>& indicator_of_brick, std::size_t max_bricks);

}  // namespace pomona
