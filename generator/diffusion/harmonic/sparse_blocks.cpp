#include "generator/diffusion/harmonic/sparse_blocks.h"

#include <bit>

namespace pomona {

namespace {

/// The first column that is wanted; 128 if none is.
std::int32_t first_of(ColumnMask columns) {
  const auto low = static_cast<std::uint64_t>(columns);
  return low != 0 ? std::countr_zero(low) : 64 + std::countr_zero(static_cast<std::uint64_t>(columns >> 64));
}

}  // namespace

SparseBlocks::SparseBlocks(const Node& count, const std::vector<ColumnMask>& wanted)
    : count_(count), row_(wanted.size()) {
  std::size_t total = 0;
  for (const ColumnMask columns : wanted) total += count_of_columns(columns);
  block_.reserve(total);
  for (std::size_t row = 0; row < wanted.size(); ++row) {
    const ColumnMask columns = wanted[row];
    if (columns == 0) continue;
    const std::int32_t lowest = first_of(columns), gapless = first_of(~(columns >> lowest));
    row_[row] = {columns, static_cast<std::uint32_t>(block_.size()), lowest, static_cast<std::uint32_t>(gapless)};
    const int y = static_cast<int>(row) % count[1], z = static_cast<int>(row) / count[1];
    for (std::int32_t column = lowest; column < lowest + gapless; ++column) block_.push_back({column, y, z});
    const ColumnMask rest = gapless < max_columns ? columns >> lowest >> gapless : 0;
    for (ColumnMask left = rest; left != 0; left &= left - 1)
      block_.push_back({lowest + gapless + first_of(left), y, z});
  }
}

SparseBlocks all_blocks(const Node& count) {
  const int columns = (count[0] + SparseBlocks::length - 1) / SparseBlocks::length;
  const ColumnMask all = ~ColumnMask{0} >> (max_columns - columns);
  return {count, std::vector<ColumnMask>(static_cast<std::size_t>(count[1] * count[2]), all)};
}

std::vector<std::pair<std::size_t, std::size_t>> SparseBlocks::ranges_of_planes(std::size_t parts) const {
  std::vector<std::pair<std::size_t, std::size_t>> ranges;
  std::size_t first = 0;
  for (std::size_t end = 1; end <= block_.size(); ++end) {
    const bool is_last = end == block_.size();
    if (!is_last && (block_[end].z == block_[end - 1].z || (end - first) * parts < block_.size())) continue;
    ranges.emplace_back(first, end);
    first = end;
  }
  return ranges;
}

}  // namespace pomona
