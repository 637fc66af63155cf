#include "generator/diffusion/harmonic/nearest_labels.h"

namespace pomona {

std::vector<std::uint32_t> nearest_labels(const GridLevel& level) {
  // Begin with the nodes that surfaces touch: their nearest cut.
  std::vector<std::uint32_t> label(level.blocks.node_count(), no_side);
  std::vector<std::uint32_t> waiting;
  waiting.reserve(label.size());
  for (const CutNode& node : level.arms.node) {
    float nearest = 2;
    const std::uint32_t end = node.first_cut + bit_counts[node.cut];
    for (std::uint32_t c = node.first_cut; c < end; ++c) {
      if (level.arms.cut[c].theta >= nearest) continue;
      nearest = level.arms.cut[c].theta;
      label[node.node] = level.arms.cut[c].side;
    }
    if (label[node.node] != no_side) waiting.push_back(node.node);
  }

  // Spread arm by arm.
  for (std::size_t next = 0; next < waiting.size(); ++next) {
    const std::uint32_t node = waiting[next];
    const BlockArms& block = level.block_arms[node / SparseBlocks::length];
    const std::array<std::int32_t, 6> offset = {-1, 1, block.y_down, block.y_up, block.z_down, block.z_up};
    for (std::size_t d = 0; d < 6; ++d) {
      if ((level.arms.open[node] >> d & 1) == 0) continue;
      const auto beside = static_cast<std::uint32_t>(static_cast<std::int32_t>(node) + offset[d]);
      if (label[beside] != no_side) continue;
      label[beside] = label[node];
      waiting.push_back(beside);
    }
  }
  return label;
}

}  // namespace pomona
