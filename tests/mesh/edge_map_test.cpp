#include "generator/mesh/edge_map.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "generator/base/random.h"

namespace pomona {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

/// Pairs of few vertices, so that most appear again, some in the other order; and pairs of the largest numbers.
std::vector<Pair> some_pairs() {
  const RandomStream random({3, 0}, "edges");
  std::vector<Pair> pairs;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    const std::uint64_t first = i % 3 == 0 ? 0xffffffe0u : 0u;
    pairs.emplace_back(first + random.below(2 * i, 32), first + random.below(2 * i + 1, 32));
  }
  return pairs;
}

TEST(EdgeKey, IsTheSameWhicheverWayTheEdgeIsRun) {
  for (const auto& [a, b] : some_pairs()) {
    const EdgeKey key(a, b);
    EXPECT_EQ(key, EdgeKey(b, a));
    EXPECT_EQ(Pair(key.low, key.high), Pair(std::minmax(a, b)));
  }
  EXPECT_NE(EdgeKey(1, 2), EdgeKey(1, 3));
  EXPECT_NE(EdgeKey(1, 3), EdgeKey(2, 3));
}

TEST(EdgeKey, IsOrderedByTheLowerVertexThenByTheHigher) {
  EXPECT_LT(EdgeKey(9, 1), EdgeKey(2, 3));
  EXPECT_LT(EdgeKey(2, 3), EdgeKey(4, 2));
}

TEST(EdgeMap, KeepsWhatASortedMapKeeps) {
  EdgeMap<int> map;
  std::map<Pair, int> known;
  int number = 0;
  for (const auto& [a, b] : some_pairs()) {
    const bool was_new = known.try_emplace(std::minmax(a, b), number).second;
    const auto [value, is_new] = map.try_emplace({a, b}, number);
    EXPECT_EQ(is_new, was_new);
    EXPECT_EQ(value, known.at(std::minmax(a, b)));
    if (++number % 5 == 0) {
      known.erase(std::minmax(a, b));
      map.erase({b, a});
    }
  }
  std::vector<EdgeKey> edges;
  for (const auto& [ends, value] : known) {
    edges.emplace_back(ends.second, ends.first);
    EXPECT_EQ(map.at({ends.second, ends.first}), value);
    EXPECT_EQ(*map.find({ends.first, ends.second}), value);
  }
  EXPECT_EQ(map.edges(), edges) << "sorted";
}

TEST(EdgeMap, TellsWhatItDoesNotHave) {
  EdgeMap<int> map;
  EXPECT_TRUE(map.empty());
  map[{7, 3}] += 2;
  EXPECT_EQ(map.at({3, 7}), 2) << "a value begins at 0";
  EXPECT_FALSE(map.empty());
  EXPECT_FALSE(map.contains({3, 3}));
  EXPECT_EQ(map.find({7, 7}), nullptr);
  map.clear();
  EXPECT_FALSE(map.contains({3, 7}));
}

TEST(EdgeMap, LeavesValuesWhereTheyAre) {
  EdgeMap<int> map;
  int& first = map[{0, 1}];
  first = 5;
  for (std::uint32_t v = 0; v < 5000; ++v) map[{v, v + 2}] = 1;
  EXPECT_EQ(&first, map.find({1, 0}));
  EXPECT_EQ(first, 5);
}

TEST(EdgeMap, MakesValuesThatCannotBeCopied) {
  EdgeMap<std::unique_ptr<int>> map;
  map.try_emplace({0, 1}, std::make_unique<int>(4));
  EXPECT_EQ(*map.at({1, 0}), 4);
}

TEST(EdgeSet, HasWhatWasPutIn) {
  EdgeSet set;
  std::set<Pair> known;
  const std::vector<Pair> pairs = some_pairs();
  for (std::size_t i = 0; i < pairs.size() / 20; ++i) {
    set.insert({pairs[i].first, pairs[i].second});
    known.insert(std::minmax(pairs[i].first, pairs[i].second));
  }
  std::size_t had = 0;
  for (const auto& [a, b] : pairs) {
    EXPECT_EQ(set.contains({b, a}), known.contains(std::minmax(a, b)));
    had += set.contains({a, b}) ? 1 : 0;
  }
  EXPECT_GT(had, pairs.size() / 20);
  EXPECT_LT(had, pairs.size());
}

}  // namespace
}  // namespace pomona
