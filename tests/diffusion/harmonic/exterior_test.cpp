#include "generator/diffusion/harmonic/exterior.h"

#include <deque>
#include <vector>

#include <gtest/gtest.h>

#include "generator/base/random.h"
#include "generator/diffusion/harmonic/cut_arms.h"
#include "tests/diffusion/harmonic/whole_shapes.h"

namespace pomona {
namespace {

/// Three words of bits along x, the last not full.
Lattice wide_lattice() {
  Lattice lattice = shapes::whole_lattice();
  lattice.count = {150, 5, 4};
  return lattice;
}

/// The share of open arms along x, and along y and z.
struct OpenShare {
  double along = 1, across = 1;
};

/// Random open arms; each arm is open or closed for both of its ends.
std::vector<std::uint8_t> random_arms(const SparseBlocks& blocks, const Lattice& lattice, const OpenShare& share,
                                      std::uint64_t seed) {
  const RandomStream random({seed, 0}, "tests/open links");
  std::vector<std::uint8_t> open(blocks.node_count(), 0);
  std::uint64_t n = 0;
  for (const Node& node : shapes::nodes_of(lattice)) {
    for (int d = 1; d < 6; d += 2) {
      const Node other = shapes::beside(node, d);
      const std::int32_t there = blocks.node_at(other[0], other[1], other[2]);
      if (there == SparseBlocks::none || random.uniform(n++) > (d == x_up ? share.along : share.across)) continue;
      const auto from = static_cast<std::size_t>(blocks.node_at(node[0], node[1], node[2]));
      const auto to = static_cast<std::size_t>(there);
      open[from] = static_cast<std::uint8_t>(open[from] | 1 << d);
      open[to] = static_cast<std::uint8_t>(open[to] | 1 << (d ^ 1));
    }
  }
  return open;
}

std::vector<std::uint8_t> reached_one_by_one(const SparseBlocks& blocks, const std::vector<std::uint8_t>& open) {
  std::vector<std::uint8_t> marked(blocks.size(), 0);
  std::deque<Node> waiting{{0, 0, 0}};
  marked[0] = 1;
  while (!waiting.empty()) {
    const Node node = waiting.front();
    waiting.pop_front();
    const auto here = static_cast<std::size_t>(blocks.node_at(node[0], node[1], node[2]));
    for (int d = 0; d < 6; ++d) {
      if ((open[here] >> d & 1) == 0) continue;
      const Node other = shapes::beside(node, d);
      const auto there = static_cast<std::size_t>(blocks.node_at(other[0], other[1], other[2]));
      if (marked[there / 8] >> there % 8 & 1) continue;
      marked[there / 8] = static_cast<std::uint8_t>(marked[there / 8] | 1 << there % 8);
      waiting.push_back(other);
    }
  }
  return marked;
}

TEST(Exterior, IsWhatArmsLeadToOneByOne) {
  const Lattice lattice = wide_lattice();
  const SparseBlocks blocks = all_blocks(lattice.count);
  // With few arms across, mistakes at the ends of rows and of their words show.
  for (const OpenShare& share : {OpenShare{0.3, 0.3}, {0.4, 0.4}, {0.95, 0.05}, {0.98, 0.02}, {1, 1}}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const std::vector<std::uint8_t> open = random_arms(blocks, lattice, share, seed);
      EXPECT_EQ(reached_from_corner(blocks, open, {2}), reached_one_by_one(blocks, open)) << share.along << " " << seed;
    }
  }
}

TEST(Exterior, LeavesOutWhatIsBehindASurface) {
  for (const std::vector<Corners>& shape : shapes::convex_shapes()) {
    const shapes::GriddedShapes gridded(shapes::surfaces_of(shape), shapes::whole_lattice());
    const std::vector<std::uint8_t> outside = reached_from_corner(gridded.blocks, gridded.finder.open(), {1});
    for (const Node& node : shapes::nodes_of(gridded.lattice)) {
      const auto number = static_cast<std::size_t>(gridded.blocks.node_at(node[0], node[1], node[2]));
      const bool is_inside = shapes::holds(shape, shapes::place_of(gridded.lattice, node));
      EXPECT_NE((outside[number / 8] >> number % 8 & 1) != 0, is_inside);
    }
  }
}

TEST(Exterior, KeepsTheRunsThatHoldSomethingElse) {
  const SparseBlocks blocks = all_blocks({19, 2, 2});
  std::vector<std::uint8_t> marked(blocks.size(), 0xff);
  marked[2] = 0b111;  // all three nodes in the lattice
  marked[4] = 0b11110111;
  marked[11] = 0b011;
  const SparseBlocks kept = blocks_without(blocks, marked);
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(kept[0].column, 1);
  EXPECT_EQ(kept[0].y, 1);
  EXPECT_EQ(kept[0].z, 0);
  EXPECT_EQ(kept[1].column, 2);
  EXPECT_EQ(kept[1].z, 1);
}

}  // namespace
}  // namespace pomona
