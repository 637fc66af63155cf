#include "generator/mesh/disjoint_sets.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "generator/base/random.h"

namespace pomona {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Pairs random_pairs(std::size_t count, std::uint64_t members) {
  const RandomStream draw({4, 0}, "tests/pairs");
  Pairs pairs;
  for (std::uint64_t i = 0; i < count; ++i) {
    pairs.emplace_back(draw.below(2 * i, members), draw.below(2 * i + 1, members));
  }
  return pairs;
}

/// For each member the least one it is connected to, found by following pairs until nothing changes.
std::vector<std::uint32_t> min_reached(const Pairs& pairs, std::uint32_t members) {
  std::vector<std::uint32_t> min(members);
  for (std::uint32_t i = 0; i < members; ++i) min[i] = i;
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [a, b] : pairs) {
      const std::uint32_t both = std::min(min[a], min[b]);
      changed = changed || min[a] != both || min[b] != both;
      min[a] = min[b] = both;
    }
  }
  return min;
}

TEST(DisjointSets, AreWhatHangsTogetherWhateverTheOrderOfJoining) {
  constexpr std::uint32_t members = 100;
  Pairs pairs = random_pairs(70, members);
  const std::vector<std::uint32_t> expected = min_reached(pairs, members);
  for (int turn = 0; turn < 3; ++turn) {
    DisjointSets sets(members);
    for (const auto& [a, b] : pairs) turn == 1 ? sets.join(b, a) : sets.join(a, b);
    for (std::uint32_t i = 0; i < members; ++i) EXPECT_EQ(sets.root(i), expected[i]);
    std::reverse(pairs.begin(), pairs.end());
  }
}

TEST(DisjointSets, GrowByMembersOfTheirOwn) {
  DisjointSets sets(2);
  sets.join(0, 1);
  sets.add();
  EXPECT_EQ(sets.count(), 3u);
  EXPECT_EQ(sets.root(2), 2u);
  sets.join(2, 1);
  EXPECT_EQ(sets.root(2), 0u);
}

}  // namespace
}  // namespace pomona
