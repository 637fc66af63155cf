#include "generator/diffusion/harmonic/nearest_labels.h"

namespace pomona {

std::vector<std::uint32_t> nearest_labels(const GridLevel& level) {
  // Begin with the nodes that surfaces touch: their nearest cut.
  std::vector<std::uint32_t> label(level.runs.node_count(), no_side);
  std::vector<std::uint32_t> waiting;
  waiting.reserve(label.size());
  for (const CutNode& node : level.links.node) {
    float nearest = 2;
    const std::uint32_t end = node.first_cut + bit_counts[node.cut];
    for (std::uint32_t c = node.first_cut; c < end; ++c) {
      if (level.links.cut[c].theta >= nearest) continue;
      nearest = level.links.cut[c].theta;
      label[node.node] = level.links.cut[c].side;
    }
    if (label[node.node] != no_side) waiting.push_back(node.node);
  }

  // Spread link by link.
  for (std::size_t next = 0; next < waiting.size(); ++next) {
    const std::uint32_t node = waiting[next];
    const RunLinks& run = level.run_links[node / NodeRuns::length];
    const std::array<std::int32_t, 6> offset = {-1, 1, run.y_down, run.y_up, run.z_down, run.z_up};
    for (std::size_t d = 0; d < 6; ++d) {
      if ((level.links.open[node] >> d & 1) == 0) continue;
      const auto beside = static_cast<std::uint32_t>(static_cast<std::int32_t>(node) + offset[d]);
      if (label[beside] != no_side) continue;
      label[beside] = label[node];
      waiting.push_back(beside);
    }
  }
  return label;
}

}  // namespace pomona
