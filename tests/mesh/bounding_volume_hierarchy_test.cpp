#include "generator/mesh/bounding_volume_hierarchy.h"

#include <numeric>

#include <gtest/gtest.h>

namespace pomona {
namespace {

struct Node {
  std::uint32_t first = 0, count = 0;
};

std::uint32_t by_half(std::uint32_t, std::uint32_t count) { return count / 2; }
std::uint32_t one_by_one(std::uint32_t, std::uint32_t) { return 1; }

/// How often each thing is in a leaf, going down from the root.
std::vector<int> times_in_a_leaf(const std::vector<Node>& nodes, std::uint32_t things, std::uint32_t max_in_leaf) {
  std::vector<int> times(things, 0);
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const std::uint32_t index = open.back();
    const Node node = nodes[index];
    open.pop_back();
    EXPECT_LE(node.count, max_in_leaf);
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) ++times[i];
    if (node.count > 0) continue;
    EXPECT_GT(node.first, index) << "children come after their parents";
    open.insert(open.end(), {node.first, node.first + 1});
  }
  return times;
}

TEST(BoundingVolumeHierarchy, HasEveryThingInOneLeaf) {
  for (const auto& split : {by_half, one_by_one}) {
    for (const std::uint32_t things : {1u, 4u, 5u, 17u, 100u}) {
      const auto nodes = bounding_volume_hierarchy<Node>(things, 4, split);
      EXPECT_EQ(times_in_a_leaf(nodes, things, 4), std::vector<int>(things, 1));
      EXPECT_EQ(nodes.size() % 2, 1u) << "a root, and children by twos";
    }
  }
}

TEST(BoundingVolumeHierarchy, DividesWhatItWasToldTo) {
  std::vector<std::uint32_t> asked;
  const auto nodes = bounding_volume_hierarchy<Node>(10, 3, [&](std::uint32_t first, std::uint32_t count) {
    asked.insert(asked.end(), {first, count});
    return count - 2;
  });
  EXPECT_EQ(asked, (std::vector<std::uint32_t>{0, 10, 0, 8, 0, 6, 0, 4}));
  EXPECT_EQ(nodes.size(), 9u);
}

TEST(BoundingVolumeHierarchy, OfNothingIsARootWithNothing) {
  const auto nodes = bounding_volume_hierarchy<Node>(0, 4, by_half);
  ASSERT_EQ(nodes.size(), 1u);
  EXPECT_EQ(nodes[0].count, 0u);
}

}  // namespace
}  // namespace pomona
