#include "generator/diffusion/harmonic/node_runs.h"

#include <bit>

namespace pomona {

namespace {

/// The first block that is wanted; as many as there are if none is.
std::int32_t first_of(BlocksOfRow blocks) {
  const auto low = static_cast<std::uint64_t>(blocks);
  return low != 0 ? std::countr_zero(low) : 64 + std::countr_zero(static_cast<std::uint64_t>(blocks >> 64));
}

}  // namespace

NodeRuns::NodeRuns(const Node& count, const std::vector<BlocksOfRow>& wanted) : count_(count), row_(wanted.size()) {
  std::size_t total = 0;
  for (const BlocksOfRow blocks : wanted) total += count_of_blocks(blocks);
  run_.reserve(total);
  for (std::size_t row = 0; row < wanted.size(); ++row) {
    const BlocksOfRow blocks = wanted[row];
    if (blocks == 0) continue;
    const std::int32_t lowest = first_of(blocks), gapless = first_of(~(blocks >> lowest));
    row_[row] = {blocks, static_cast<std::uint32_t>(run_.size()), lowest, static_cast<std::uint32_t>(gapless)};
    const int y = static_cast<int>(row) % count[1], z = static_cast<int>(row) / count[1];
    for (std::int32_t block = lowest; block < lowest + gapless; ++block) run_.push_back({block, y, z});
    const BlocksOfRow rest = gapless < most_blocks ? blocks >> lowest >> gapless : 0;
    for (BlocksOfRow left = rest; left != 0; left &= left - 1)
      run_.push_back({lowest + gapless + first_of(left), y, z});
  }
}

NodeRuns all_node_runs(const Node& count) {
  const int blocks = (count[0] + NodeRuns::length - 1) / NodeRuns::length;
  const BlocksOfRow all = ~BlocksOfRow{0} >> (most_blocks - blocks);
  return {count, std::vector<BlocksOfRow>(static_cast<std::size_t>(count[1] * count[2]), all)};
}

std::vector<std::pair<std::size_t, std::size_t>> NodeRuns::ranges_of_planes(std::size_t parts) const {
  std::vector<std::pair<std::size_t, std::size_t>> ranges;
  std::size_t first = 0;
  for (std::size_t end = 1; end <= run_.size(); ++end) {
    const bool is_last = end == run_.size();
    if (!is_last && (run_[end].z == run_[end - 1].z || (end - first) * parts < run_.size())) continue;
    ranges.emplace_back(first, end);
    first = end;
  }
  return ranges;
}

}  // namespace pomona
