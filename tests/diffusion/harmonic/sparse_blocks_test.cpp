#include "generator/diffusion/harmonic/sparse_blocks.h"

#include <bit>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "generator/base/random.h"

namespace pomona {
namespace {

constexpr Node count{19, 5, 4};

/// Some columns of some rows, and which.
std::vector<ColumnMask> some_blocks() {
  const RandomStream random({}, "tests/blocks of rows");
  std::vector<ColumnMask> wanted;
  for (std::uint64_t row = 0; row < 20; ++row) wanted.push_back(random.bits(row) & 7);
  wanted[3] = wanted[12] = 0;
  return wanted;
}

TEST(SparseBlocks, GoFromNodesToRunsAndBack) {
  const std::vector<ColumnMask> wanted = some_blocks();
  const SparseBlocks blocks(count, wanted);
  std::set<std::int32_t> seen;
  for (int z = 0; z < count[2]; ++z) {
    for (int y = 0; y < count[1]; ++y) {
      for (int x = 0; x < count[0]; ++x) {
        const std::int32_t node = blocks.node_at(x, y, z);
        const bool is_wanted = wanted[static_cast<std::size_t>(z * count[1] + y)] >> (x / 8) & 1;
        ASSERT_EQ(node != SparseBlocks::none, is_wanted);
        if (!is_wanted) continue;
        const NodeBlock& block = blocks[static_cast<std::size_t>(node) / 8];
        EXPECT_EQ(8 * block.column + node % 8, x);
        EXPECT_EQ(block.y, y);
        EXPECT_EQ(block.z, z);
        EXPECT_TRUE(seen.insert(node).second);
      }
    }
  }
  std::size_t inside = 0;
  for (std::size_t r = 0; r < blocks.size(); ++r) inside += static_cast<std::size_t>(blocks.inside(r));
  EXPECT_EQ(seen.size(), inside);
  EXPECT_EQ(blocks.node_count(), 8 * blocks.size());
}

TEST(SparseBlocks, HaveNothingOutsideTheLattice) {
  const SparseBlocks blocks = all_blocks(count);
  EXPECT_EQ(blocks.size(), 3u * 5 * 4);
  EXPECT_EQ(blocks.inside(2), 3);
  for (const Node& node : {Node{-1, 0, 0}, {19, 0, 0}, {0, -1, 0}, {0, 5, 0}, {0, 0, -1}, {0, 0, 4}})
    EXPECT_EQ(blocks.node_at(node[0], node[1], node[2]), SparseBlocks::none);
  EXPECT_NE(blocks.node_at(18, 4, 3), SparseBlocks::none);
  EXPECT_EQ(blocks.at(3, 0, 0), SparseBlocks::none);
  EXPECT_EQ(blocks.at(max_columns, 0, 0), SparseBlocks::none);
}

TEST(SparseBlocks, HoldTheLongestRow) {
  const SparseBlocks blocks = all_blocks({max_nodes, 2, 1});
  EXPECT_EQ(blocks.size(), 2u * max_columns);
  EXPECT_EQ(blocks.node_at(max_nodes - 1, 1, 0), 2 * max_nodes - 1);
}

TEST(SparseBlocks, PartIntoRangesOfWholePlanes) {
  const SparseBlocks blocks = all_blocks({9, 3, 13});
  for (const std::size_t parts : {1u, 4u, 100u}) {
    const auto ranges = blocks.ranges_of_planes(parts);
    EXPECT_GE(ranges.size(), std::min<std::size_t>(parts, 13));
    std::size_t next = 0;
    for (const auto& [first, end] : ranges) {
      EXPECT_EQ(first, next);
      EXPECT_LT(first, end);
      if (end < blocks.size()) {
        EXPECT_NE(blocks[end - 1].z, blocks[end].z);
      }
      next = end;
    }
    EXPECT_EQ(next, blocks.size());
  }
}

TEST(SparseBlocks, CountBitsWithoutAnInstructionForIt) {
  const RandomStream random({}, "tests/bits");
  for (std::uint64_t n = 0; n < 200; ++n) {
    const std::uint64_t bits = random.bits(n) & random.bits(n / 2 + 1000);
    EXPECT_EQ(count_of_bits(bits), static_cast<std::uint32_t>(std::popcount(bits)));
  }
  EXPECT_EQ(count_of_bits(0), 0u);
  EXPECT_EQ(count_of_bits(~std::uint64_t{0}), 64u);
}

}  // namespace
}  // namespace pomona
