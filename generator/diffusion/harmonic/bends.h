// Where a solved grid is too coarse for what it has found: where the solution bends between its nodes.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/diffusion/harmonic/grid_level.h"

namespace pomona {

/// How far a solved node strays from the straight line between what lies next to it along an axis, a node or a surface:
/// the most over axes and channels, in parts of full colour. A look-up between nodes errs by about a quarter of it.
float bend_at(const GridLevel& level, std::size_t run, int k);

/// For each brick of a level's lattice (patches.h) the largest bend of the nodes that it touches; 0 where that is below
/// `least`. Same for any number of threads.
std::vector<float> bends_of_bricks(const GridLevel& level, double least, Threads threads);

/// Marks the bricks that bend. Where these are more than `most`, the straightest are left out.
std::vector<std::uint8_t> most_bent(const std::vector<float>& bend_of_brick, std::size_t most);

}  // namespace pomona
