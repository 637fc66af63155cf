// Which nodes of a lattice are stored: runs of eight along x, so that what is not needed costs nothing.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "generator/diffusion/harmonic/lattice.h"

namespace pomona {

/// Directions of links: 2 * axis, + 1 towards larger coordinates.
enum Direction : int { x_down, x_up, y_down, y_up, z_down, z_up };

/// How many bits are set; the plainest x86-64 has no instruction for it.
constexpr std::uint32_t count_of_bits(std::uint64_t bits) {
  bits -= bits >> 1 & 0x5555555555555555u;
  bits = (bits & 0x3333333333333333u) + (bits >> 2 & 0x3333333333333333u);
  bits = (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0fu;
  return static_cast<std::uint32_t>(bits * 0x0101010101010101u >> 56);
}

/// Eight nodes from (8 * block, y, z) on.
struct NodeRun {
  std::int32_t block = 0, y = 0, z = 0;
};

/// Which blocks of a row along x are wanted: a bit each. Hence at most 1024 nodes along x.
__extension__ using BlocksOfRow = unsigned __int128;
constexpr int most_blocks = 128;
constexpr int most_nodes = 1024;  ///< along x; a patch may have more along y and z

constexpr std::uint32_t count_of_blocks(BlocksOfRow blocks) {
  return count_of_bits(static_cast<std::uint64_t>(blocks)) + count_of_bits(static_cast<std::uint64_t>(blocks >> 64));
}

/// Sorted by z, then y, then block; run r holds the stored nodes 8 r to 8 r + 7. The last run of a row may reach
/// beyond the lattice.
class NodeRuns {
 public:
  static constexpr int length = 8;
  static constexpr std::int32_t none = -1;

  NodeRuns() = default;

  /// \param wanted per row, at z * count.y + y
  NodeRuns(const Node& count, const std::vector<BlocksOfRow>& wanted);

  const Node& count() const { return count_; }
  std::size_t size() const { return run_.size(); }
  std::size_t node_count() const { return run_.size() * length; }
  const NodeRun& operator[](std::size_t r) const { return run_[r]; }

  /// How many nodes of run r lie in the lattice: the first ones.
  int inside(std::size_t r) const { return std::min(length, count_[0] - length * run_[r].block); }

  /// The run over (block, y, z); none outside the lattice too.
  std::int32_t at(int block, int y, int z) const {
    if (block < 0 || y < 0 || z < 0 || block >= most_blocks || y >= count_[1] || z >= count_[2]) return none;
    const Row& row =
        row_[static_cast<std::size_t>(z) * static_cast<std::size_t>(count_[1]) + static_cast<std::size_t>(y)];
    const auto ahead = static_cast<std::uint32_t>(block - row.lowest);
    if (ahead < row.gapless) return static_cast<std::int32_t>(row.first + ahead);
    if ((row.blocks >> block & 1) == 0) return none;
    return static_cast<std::int32_t>(row.first + count_of_blocks(row.blocks & ((BlocksOfRow{1} << block) - 1)));
  }

  /// The stored node at (x, y, z); none where it is not stored.
  std::int32_t node_at(int x, int y, int z) const {
    if (x < 0 || x >= count_[0]) return none;
    const std::int32_t found = at(x / length, y, z);
    return found == none ? none : found * length + x % length;
  }

  /// Ranges of whole planes with about as many runs each.
  std::vector<std::pair<std::size_t, std::size_t>> ranges_of_planes(std::size_t parts) const;

  std::size_t bytes() const { return run_.size() * sizeof(NodeRun) + row_.size() * sizeof(Row); }

 private:
  /// Nearly all rows have no gap: there the place of a block needs no counting.
  struct Row {
    BlocksOfRow blocks = 0;
    std::uint32_t first = 0;
    std::int32_t lowest = 0;    ///< the first block
    std::uint32_t gapless = 0;  ///< blocks from there to the first gap
  };
  Node count_{};
  std::vector<NodeRun> run_;
  std::vector<Row> row_;
};

/// All of a lattice.
NodeRuns all_node_runs(const Node& count);

}  // namespace pomona
