#include "generator/mesh/crossings/intersections.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/random.h"
#include "tests/cut/carve/arranged_shapes.h"
#include "tests/cut/carve/moved_knife.h"

namespace pomona {
namespace {

using shapes::at_rest;
using shapes::moved;
using shapes::sign_of_volume;
using shapes::WidePoint;
using WideTriangle = std::array<WidePoint, 3>;

WideTriangle at_rest(const Corners& t) { return {at_rest(t[0]), at_rest(t[1]), at_rest(t[2])}; }
WideTriangle moved(const Corners& t) { return {moved(t[0]), moved(t[1]), moved(t[2])}; }

/// Whether segment pq passes through the triangle, none of its corners in the other's planes.
bool passes(const WidePoint& p, const WidePoint& q, const WideTriangle& t) {
  if (sign_of_volume(t[0], t[1], t[2], p) == sign_of_volume(t[0], t[1], t[2], q)) return false;
  const int first = sign_of_volume(p, q, t[0], t[1]);
  return sign_of_volume(p, q, t[1], t[2]) == first && sign_of_volume(p, q, t[2], t[0]) == first;
}

/// The number of the six edges of two triangles that pass through the other triangle: two, if these intersect.
int passing_edges(const WideTriangle& a, const WideTriangle& b) {
  int count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    count += passes(a[i], a[(i + 1) % 3], b) ? 1 : 0;
    count += passes(b[i], b[(i + 1) % 3], a) ? 1 : 0;
  }
  return count;
}

std::vector<Corners> whole_triangles(std::uint64_t first) {
  const RandomStream random({}, "tests/whole triangles");
  std::vector<Corners> all;
  for (std::uint64_t n = first; all.size() < 60; n += 9) {
    Corners t;
    for (std::uint64_t i = 0; i < 9; ++i)
      t[i / 3][static_cast<int>(i % 3)] = static_cast<double>(random.below(n + i, 4));
    if (glm::cross(t[1] - t[0], t[2] - t[0]) != glm::dvec3(0)) all.push_back(t);
  }
  return all;
}

TEST(Intersections, AreThoseOfAKnifeThatHasMoved) {
  const std::vector<Corners> fruit = whole_triangles(0), knife = whole_triangles(100'000);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> wanted, found;
  for (std::uint32_t f = 0; f < fruit.size(); ++f) {
    for (std::uint32_t k = 0; k < knife.size(); ++k) {
      const int count = passing_edges(at_rest(fruit[f]), moved(knife[k]));
      ASSERT_TRUE(count == 0 || count == 2);
      if (count == 2) wanted.emplace_back(f, k);
    }
  }
  for (const Intersection& m : intersections(fruit, knife)) found.emplace_back(m.fruit, m.knife);
  EXPECT_EQ(found, wanted);
  EXPECT_GT(found.size(), 300u);
}

TEST(Intersections, AreTheSameAmongAllPairs) {
  const std::vector<Corners> fruit = whole_triangles(0), knife = whole_triangles(100'000);
  std::vector<BoxPair> pairs;
  for (std::uint32_t k = 0; k < knife.size(); ++k)
    for (std::uint32_t f = 0; f < fruit.size(); ++f) pairs.emplace_back(f, k);
  const std::vector<Intersection> all = intersections(fruit, knife), found = intersections(fruit, knife, pairs, {1});
  ASSERT_EQ(found.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(std::tie(found[i].fruit, found[i].knife), std::tie(all[i].fruit, all[i].knife));
    EXPECT_EQ(found[i].from.edge, all[i].from.edge);
    EXPECT_EQ(found[i].to.of_fruit, all[i].to.of_fruit);
  }
}

TEST(Intersections, RunWithTheFrontOfTheFruitOnTheirLeft) {
  // In the planes of x and z, and of x and y; seen from outside the knife, from +y, the fruit's front is at -z.
  const std::vector<Corners> fruit = {{{{0, -1, 0}, {0, 1, 0}, {4, 0, 0}}}};
  ASSERT_LT(glm::cross(fruit[0][1] - fruit[0][0], fruit[0][2] - fruit[0][0]).z, 0);
  const std::vector<Corners> knife = {{{{1, 0, -1}, {1, 0, 1}, {5, 0, 0}}}};
  ASSERT_GT(glm::cross(knife[0][1] - knife[0][0], knife[0][2] - knife[0][0]).y, 0);
  const std::vector<Intersection> found = intersections(fruit, knife);
  ASSERT_EQ(found.size(), 1u);
  // Seen from above with -z on the left, the direction is +x: from the knife's edge at x = 1 to the fruit's tip at 4.
  EXPECT_FALSE(found[0].from.of_fruit);
  EXPECT_EQ(found[0].from.edge, 0);
  EXPECT_TRUE(found[0].to.of_fruit);
}

/// An edge that passes through a triangle does so for both triangles at it: an intersection of the one ends where one
/// of the other begins. So intersections of closed surfaces form loops.
TEST(Intersections, GoOnFromTriangleToTriangle) {
  using End = std::tuple<bool, std::array<double, 6>, std::uint32_t>;  // kind of edge, its ends, the triangle it passes
  for (const shapes::FruitAndKnife& pair : shapes::fruits_and_knives()) {
    std::map<End, int> balance;
    const auto end_of = [&](const Crossing& c, const Intersection& m) {
      const Corners& t = c.of_fruit ? pair.fruit[m.fruit] : pair.knife[m.knife];
      const glm::dvec3 &p = t[c.edge], &q = t[(c.edge + 1u) % 3];
      std::array<double, 6> ends{p.x, p.y, p.z, q.x, q.y, q.z};
      if (std::tuple(q.x, q.y, q.z) < std::tuple(p.x, p.y, p.z))
        std::rotate(ends.begin(), ends.begin() + 3, ends.end());
      return End(c.of_fruit, ends, c.of_fruit ? m.knife : m.fruit);
    };
    const std::vector<Intersection> found = intersections(pair.fruit, pair.knife);
    EXPECT_GT(found.size(), 2u);
    for (const Intersection& m : found) {
      ++balance[end_of(m.from, m)];
      --balance[end_of(m.to, m)];
    }
    for (const auto& [end, sum] : balance) EXPECT_EQ(sum, 0);
  }
}

}  // namespace
}  // namespace pomona
