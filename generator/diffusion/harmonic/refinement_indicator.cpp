#include "generator/diffusion/harmonic/refinement_indicator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

#include "generator/diffusion/harmonic/patches.h"

namespace pomona {

namespace {

/// The value at the end of one arm of a node, and the length of the arm (1 = the spacing).
struct Seen {
  Quad value{};
  float length = 1;
  bool is_there = false;
};

/// The ends of all six arms.
std::array<Seen, 6> seen_from(const GridLevel& level, std::size_t block, int k) {
  const BlockArms& arms = level.block_arms[block];
  const std::array<std::ptrdiff_t, 6> offset = {-1, 1, arms.y_down, arms.y_up, arms.z_down, arms.z_up};
  const std::size_t node = SparseBlocks::length * block + static_cast<std::size_t>(k);
  const std::uint8_t open = level.arms.open[node];
  std::array<Seen, 6> seen;
  for (std::size_t d = 0; d < 6; ++d) {
    if (open >> d & 1) seen[d] = {level.value[node + static_cast<std::size_t>(offset[d])], 1, true};
  }
  if (open == all_open) return seen;
  const CutNode& cut = level.arms.node[level.stencil_of(block, k)];
  std::uint32_t next = cut.first_cut;
  for (std::size_t d = 0; d < 6; ++d) {
    if ((cut.cut >> d & 1) == 0) continue;
    const ArmCut& end = level.arms.cut[next++];
    seen[d] = {Quad{end.color.r, end.color.g, end.color.b, 1}, end.theta, true};
  }
  return seen;
}

/// A brick by number, and its indicator.
using BrickIndicator = std::pair<std::size_t, float>;

/// Adds the bricks that meet at a node.
void add_bricks_at(const Lattice& lattice, const Node& at, float indicator, std::vector<BrickIndicator>& found) {
  const Node count = bricks_of(lattice);
  Node low{}, high{};
  for (std::size_t a = 0; a < 3; ++a) {
    low[a] = std::clamp((at[a] - 1) / brick[a], 0, count[a] - 1);
    high[a] = std::clamp(at[a] / brick[a], 0, count[a] - 1);
  }
  for (int z = low[2]; z <= high[2]; ++z) {
    for (int y = low[1]; y <= high[1]; ++y) {
      for (int x = low[0]; x <= high[0]; ++x) found.emplace_back(brick_index({x, y, z}, count), indicator);
    }
  }
}

}  // namespace

float indicator_at(const GridLevel& level, std::size_t block, int k) {
  const std::size_t node = SparseBlocks::length * block + static_cast<std::size_t>(k);
  const std::array<Seen, 6> seen = seen_from(level, block, k);
  float largest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Seen &below = seen[2 * axis], &above = seen[2 * axis + 1];
    if (!below.is_there || !above.is_there) continue;
    const float length = below.length + above.length;
    if (!(length > 0)) continue;
    const Quad off = level.value[node] - (above.length * below.value + below.length * above.value) / length;
    for (std::size_t channel = 0; channel < 3; ++channel) largest = std::max(largest, std::fabs(off[channel]));
  }
  return largest;
}

std::vector<float> indicator_of_bricks(const GridLevel& level, double threshold, Threads threads) {
  // Each range of planes measures its own nodes.
  const auto enough = static_cast<float>(threshold);
  std::vector<std::vector<BrickIndicator>> found(level.ranges.size());
  parallel_for(level.ranges.size(), threads, [&](std::size_t i) {
    for (std::size_t r = level.ranges[i].first; r < level.ranges[i].second; ++r) {
      const NodeBlock& block = level.blocks[r];
      for (int k = 0; k < SparseBlocks::length; ++k) {
        if (level.arms.open[SparseBlocks::length * r + static_cast<std::size_t>(k)] & (takes_no_part | is_given))
          continue;
        const float indicator = indicator_at(level, r, k);
        if (indicator < enough) continue;
        add_bricks_at(level.lattice, {SparseBlocks::length * block.column + k, block.y, block.z}, indicator, found[i]);
      }
    }
  });

  // The indicator of a brick is the largest of its nodes.
  const Node count = bricks_of(level.lattice);
  std::vector<float> indicator_of_brick(static_cast<std::size_t>(count[0]) *
                                        static_cast<std::size_t>(count[1] * count[2]));
  for (const auto& part : found) {
    for (const auto& [number, indicator] : part)
      indicator_of_brick[number] = std::max(indicator_of_brick[number], indicator);
  }
  return indicator_of_brick;
}

std::vector<std::uint8_t> bricks_to_refine(const std::vector<float>& indicator_of_brick, std::size_t max_bricks) {
  // Of bricks with equal indicators all or none are marked: their order must not matter.
  std::vector<float> positive;
  std::copy_if(indicator_of_brick.begin(), indicator_of_brick.end(), std::back_inserter(positive),
               [](float indicator) { return indicator > 0; });
  float threshold = 0;
  if (positive.size() > max_bricks) {
    const auto first_out = positive.begin() + static_cast<std::ptrdiff_t>(max_bricks);
    std::nth_element(positive.begin(), first_out, positive.end(), std::greater<>());
    threshold = *first_out;
  }
  std::vector<std::uint8_t> is_marked(indicator_of_brick.size());
  std::transform(indicator_of_brick.begin(), indicator_of_brick.end(), is_marked.begin(),
                 [&](float indicator) { return indicator > threshold ? 1 : 0; });
  return is_marked;
}

}  // namespace pomona
