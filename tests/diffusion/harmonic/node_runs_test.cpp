#include "generator/diffusion/harmonic/node_runs.h"

#include <bit>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "generator/base/random.h"

namespace pomona {
namespace {

constexpr Node count{19, 5, 4};

/// Some blocks of some rows, and which.
std::vector<BlocksOfRow> some_blocks() {
  const RandomStream random({}, "tests/blocks of rows");
  std::vector<BlocksOfRow> wanted;
  for (std::uint64_t row = 0; row < 20; ++row) wanted.push_back(random.bits(row) & 7);
  wanted[3] = wanted[12] = 0;
  return wanted;
}

TEST(NodeRuns, GoFromNodesToRunsAndBack) {
  const std::vector<BlocksOfRow> wanted = some_blocks();
  const NodeRuns runs(count, wanted);
  std::set<std::int32_t> seen;
  for (int z = 0; z < count[2]; ++z) {
    for (int y = 0; y < count[1]; ++y) {
      for (int x = 0; x < count[0]; ++x) {
        const std::int32_t node = runs.node_at(x, y, z);
        const bool is_wanted = wanted[static_cast<std::size_t>(z * count[1] + y)] >> (x / 8) & 1;
        ASSERT_EQ(node != NodeRuns::none, is_wanted);
        if (!is_wanted) continue;
        const NodeRun& run = runs[static_cast<std::size_t>(node) / 8];
        EXPECT_EQ(8 * run.block + node % 8, x);
        EXPECT_EQ(run.y, y);
        EXPECT_EQ(run.z, z);
        EXPECT_TRUE(seen.insert(node).second);
      }
    }
  }
  std::size_t inside = 0;
  for (std::size_t r = 0; r < runs.size(); ++r) inside += static_cast<std::size_t>(runs.inside(r));
  EXPECT_EQ(seen.size(), inside);
  EXPECT_EQ(runs.node_count(), 8 * runs.size());
}

TEST(NodeRuns, HaveNothingOutsideTheLattice) {
  const NodeRuns runs = all_node_runs(count);
  EXPECT_EQ(runs.size(), 3u * 5 * 4);
  EXPECT_EQ(runs.inside(2), 3);
  for (const Node& node : {Node{-1, 0, 0}, {19, 0, 0}, {0, -1, 0}, {0, 5, 0}, {0, 0, -1}, {0, 0, 4}})
    EXPECT_EQ(runs.node_at(node[0], node[1], node[2]), NodeRuns::none);
  EXPECT_NE(runs.node_at(18, 4, 3), NodeRuns::none);
  EXPECT_EQ(runs.at(3, 0, 0), NodeRuns::none);
  EXPECT_EQ(runs.at(most_blocks, 0, 0), NodeRuns::none);
}

TEST(NodeRuns, HoldTheLongestRow) {
  const NodeRuns runs = all_node_runs({most_nodes, 2, 1});
  EXPECT_EQ(runs.size(), 2u * most_blocks);
  EXPECT_EQ(runs.node_at(most_nodes - 1, 1, 0), 2 * most_nodes - 1);
}

TEST(NodeRuns, PartIntoRangesOfWholePlanes) {
  const NodeRuns runs = all_node_runs({9, 3, 13});
  for (const std::size_t parts : {1u, 4u, 100u}) {
    const auto ranges = runs.ranges_of_planes(parts);
    EXPECT_GE(ranges.size(), std::min<std::size_t>(parts, 13));
    std::size_t next = 0;
    for (const auto& [first, end] : ranges) {
      EXPECT_EQ(first, next);
      EXPECT_LT(first, end);
      if (end < runs.size()) {
        EXPECT_NE(runs[end - 1].z, runs[end].z);
      }
      next = end;
    }
    EXPECT_EQ(next, runs.size());
  }
}

TEST(NodeRuns, CountBitsWithoutAnInstructionForIt) {
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
