// The stored nodes of a lattice: sparse blocks of eight nodes along x. Blocks that are not needed take no memory.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "generator/diffusion/harmonic/lattice.h"

namespace pomona {

/// Directions of stencil arms: 2 * axis, + 1 towards larger coordinates.
enum Direction : int { x_down, x_up, y_down, y_up, z_down, z_up };

/// The number of bits set. Baseline x86-64 has no instruction for it.
constexpr std::uint32_t count_of_bits(std::uint64_t bits) {
  bits -= bits >> 1 & 0x5555555555555555u;
  bits = (bits & 0x3333333333333333u) + (bits >> 2 & 0x3333333333333333u);
  bits = (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0fu;
  return static_cast<std::uint32_t>(bits * 0x0101010101010101u >> 56);
}

/// Eight nodes: (8 * column, y, z) to (8 * column + 7, y, z).
struct NodeBlock {
  std::int32_t column = 0, y = 0, z = 0;
};

/// The wanted columns of a row along x, a bit each. Hence a lattice has at most 1024 nodes along x.
__extension__ using ColumnMask = unsigned __int128;
constexpr int max_columns = 128;
constexpr int max_nodes = 1024;  ///< along x; a patch may have more along y and z

constexpr std::uint32_t count_of_columns(ColumnMask columns) {
  return count_of_bits(static_cast<std::uint64_t>(columns)) + count_of_bits(static_cast<std::uint64_t>(columns >> 64));
}

/// The blocks, sorted by z, then y, then column. Block r holds the stored nodes 8 r to 8 r + 7. The last block of a row
/// may reach beyond the lattice.
class SparseBlocks {
 public:
  static constexpr int length = 8;
  static constexpr std::int32_t none = -1;

  SparseBlocks() = default;

  /// \param wanted per row, at z * count.y + y
  SparseBlocks(const Node& count, const std::vector<ColumnMask>& wanted);

  const Node& count() const { return count_; }
  std::size_t size() const { return block_.size(); }
  std::size_t node_count() const { return block_.size() * length; }
  const NodeBlock& operator[](std::size_t r) const { return block_[r]; }

  /// The number of nodes of block r that lie in the lattice; they are its first ones.
  int inside(std::size_t r) const { return std::min(length, count_[0] - length * block_[r].column); }

  /// The block at (column, y, z); `none` where it is not stored, and outside the lattice.
  std::int32_t at(int column, int y, int z) const {
    if (column < 0 || y < 0 || z < 0 || column >= max_columns || y >= count_[1] || z >= count_[2]) return none;
    const Row& row =
        row_[static_cast<std::size_t>(z) * static_cast<std::size_t>(count_[1]) + static_cast<std::size_t>(y)];
    const auto ahead = static_cast<std::uint32_t>(column - row.lowest);
    if (ahead < row.gapless) return static_cast<std::int32_t>(row.first + ahead);
    if ((row.columns >> column & 1) == 0) return none;
    return static_cast<std::int32_t>(row.first + count_of_columns(row.columns & ((ColumnMask{1} << column) - 1)));
  }

  /// The stored node at (x, y, z); `none` where it is not stored.
  std::int32_t node_at(int x, int y, int z) const {
    if (x < 0 || x >= count_[0]) return none;
    const std::int32_t found = at(x / length, y, z);
    return found == none ? none : found * length + x % length;
  }

  /// Ranges of whole planes with about as many blocks each.
  std::vector<std::pair<std::size_t, std::size_t>> ranges_of_planes(std::size_t parts) const;

  std::size_t bytes() const { return block_.size() * sizeof(NodeBlock) + row_.size() * sizeof(Row); }

 private:
  /// A row along x. Nearly all rows have no gap; there the index of a block is found without counting bits.
  struct Row {
    ColumnMask columns = 0;
    std::uint32_t first = 0;    ///< index of its first block
    std::int32_t lowest = 0;    ///< its first column
    std::uint32_t gapless = 0;  ///< number of columns from there to the first gap
  };
  Node count_{};
  std::vector<NodeBlock> block_;
  std::vector<Row> row_;
};

/// All blocks of a lattice.
SparseBlocks all_blocks(const Node& count);

}  // namespace pomona
