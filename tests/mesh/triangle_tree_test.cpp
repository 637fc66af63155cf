#include "generator/mesh/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/mesh/triangle_distance.h"
#include "generator/mesh/weld.h"
#include "tests/mesh/random_points.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

TriangleTree tree_of(const DiffusionSurfaces& surfaces) { return {surfaces.position, surfaces.triangle}; }

TEST(TriangleTree, FindsTheNearestPointAsTryingAllTrianglesDoes) {
  const TriangleTree tree = tree_of(shapes::torus(2, 0.7, 24, 12));
  for (const glm::dvec3& p : random_points(200, 3)) {
    double min = 1e9;
    for (const TriangleTree::Corners& t : tree.triangles())
      min = std::min(min, glm::distance(p, nearest_on_triangle(p, t)));
    const TriangleTree::Nearest found = tree.nearest(p);
    EXPECT_DOUBLE_EQ(found.distance, min);
    EXPECT_DOUBLE_EQ(glm::distance(found.point, p), min);
    EXPECT_EQ(tree.nearest(p, 0.999 * min).distance, std::numeric_limits<double>::infinity());
  }
}

TEST(TriangleTree, ContainsWhatItsMeshWindsAround) {
  // Rays from these points pass through the box's vertices, edges and diagonals.
  const TriangleTree box = tree_of(shapes::box({-1, -1, -1}, {1, 1, 1}, 2));
  for (int x = -5; x <= 5; ++x) {
    for (int y = -5; y <= 5; ++y) {
      for (int z = -5; z <= 5; ++z) {
        const glm::dvec3 p = 0.37 * glm::dvec3(x, y, z);
        const bool inside = std::max({std::abs(x), std::abs(y), std::abs(z)}) < 3;
        EXPECT_EQ(box.contains(p), inside) << p.x << " " << p.y << " " << p.z;
      }
    }
  }
  const TriangleTree ring = tree_of(shapes::torus(2, 0.7, 96, 48));
  for (const glm::dvec3& p : random_points(500, 3)) {
    const double from_tube = std::hypot(std::hypot(p.x, p.z) - 2, p.y) - 0.7;
    if (std::abs(from_tube) > 0.01) {
      EXPECT_EQ(ring.contains(p), from_tube < 0);
    }
  }
}

TEST(TriangleTree, FindsWhatLiesBelow) {
  const TriangleTree ball = tree_of(shapes::sphere(1, 24));
  for (const glm::dvec3& p : random_points(300, 1)) {
    const double across = p.x * p.x + p.z * p.z;
    if (across > 0.95) continue;
    const double half = std::sqrt(1 - across);
    const double expected = p.y >= half ? half : -half;
    if (std::abs(std::abs(p.y) - half) < 0.02) continue;
    const double found = ball.height_below(p);
    if (p.y < -half) {
      EXPECT_EQ(found, -std::numeric_limits<double>::infinity());
    } else {
      EXPECT_NEAR(found, expected, 0.02);
    }
  }
}

TEST(TriangleTree, IsNearBoxesThatMeetATrianglesBox) {
  const TriangleTree tree = tree_of(shapes::torus(2, 0.7, 24, 12));
  int near = 0;
  for (const glm::dvec3& p : random_points(300, 3)) {
    const Box<double> box{p - 0.1, p + 0.1};
    const bool expected = std::any_of(tree.triangles().begin(), tree.triangles().end(),
                                      [&](const auto& t) { return box_around(t[0], t[1], t[2]).meets(box); });
    EXPECT_EQ(tree.is_near(box), expected);
    near += expected ? 1 : 0;
  }
  EXPECT_GT(near, 20);
  EXPECT_LT(near, 280);
}

TEST(TriangleTree, IsAsFarFromAnotherAsTheirNearestTriangles) {
  const TriangleTree a = tree_of(shapes::tilted(shapes::box({-1, -1, -1}, {1, 1, 1}))),
                     b = tree_of(shapes::sphere(1, 4));
  for (const glm::dvec3& offset : random_points(60, 3)) {
    double min = 1e9;
    for (const TriangleTree::Corners& t : a.triangles()) {
      for (TriangleTree::Corners u : b.triangles()) {
        for (glm::dvec3& corner : u) corner += offset;
        const auto [p, q] = nearest_on_triangles(t, u);
        min = std::min(min, glm::distance(p, q));
      }
    }
    const ClosestPair found = closest(a, b, offset, 100);
    EXPECT_DOUBLE_EQ(found.distance, min);
    EXPECT_DOUBLE_EQ(glm::distance(found.first, found.second), min);
  }
}

TEST(TriangleTree, TurnsAsItsTrianglesDo) {
  const TriangleTree tree = tree_of(shapes::box({0, 0, 0}, {1, 2, 3}, 3));
  const glm::dquat turn = glm::normalize(glm::dquat(0.8, 0.1, 0.5, -0.2));
  const TriangleTree turned = tree.rotated(turn);
  for (const glm::dvec3& p : random_points(100, 4)) {
    EXPECT_NEAR(turned.nearest(turn * p).distance, tree.nearest(p).distance, 1e-12);
    EXPECT_EQ(turned.contains(turn * p), tree.contains(p));
  }
}

TEST(TriangleTree, OwnsEveryCornerOnce) {
  const DiffusionSurfaces ball = shapes::sphere(1, 6);
  const TriangleTree tree = tree_of(ball);
  std::size_t owned = 0, places = 0;
  for (std::size_t t = 0; t < tree.triangles().size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) owned += tree.owns_corner(t, k) ? 1 : 0;
  }
  const std::vector<std::uint32_t> first = weld(ball.position);
  for (std::size_t v = 0; v < first.size(); ++v) places += first[v] == v ? 1 : 0;
  EXPECT_EQ(owned, places);
}

TEST(TriangleTree, OfNothingIsFarFromEverything) {
  const TriangleTree none{std::vector<glm::vec3>{}, std::vector<glm::uvec3>{}};
  EXPECT_TRUE(none.empty());
  EXPECT_FALSE(none.contains({0, 0, 0}));
  EXPECT_FALSE(none.is_near({glm::dvec3(-1), glm::dvec3(1)}));
  EXPECT_EQ(none.nearest({0, 0, 0}).distance, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace pomona
