#include "generator/mesh/convex_hull.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/mesh/edges.h"
#include "tests/mesh/random_points.h"

namespace pomona {
namespace {

TEST(ConvexHull, IsClosedAndHasAllPointsBehindEachFace) {
  const std::vector<glm::dvec3> points = random_points(200, 1);
  const ConvexHull hull = convex_hull(points);
  EXPECT_TRUE(is_closed(hull.triangle));
  for (const glm::uvec3& t : hull.triangle) {
    const glm::dvec3 &a = hull.point[t.x], &b = hull.point[t.y], &c = hull.point[t.z];
    const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
    for (const glm::dvec3& p : points) EXPECT_LT(glm::dot(normal, p - a), 1e-3) << "but for rounding to 1e-4";
  }
  for (const glm::dvec3& corner : hull.point) {
    EXPECT_NE(std::find(points.begin(), points.end(), corner), points.end()) << "corners are given points, unrounded";
  }
}

TEST(ConvexHull, OfACubesCornersAndInnerPointsIsTheCube) {
  std::vector<glm::dvec3> points = random_points(50, 0.9);
  for (int k = 0; k < 8; ++k) points.emplace_back(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
  const ConvexHull hull = convex_hull(points);
  EXPECT_EQ(hull.point.size(), 8u);
  EXPECT_EQ(hull.triangle.size(), 12u);
  EXPECT_NEAR(volume(hull), 8, 1e-12);
}

TEST(ConvexHull, OfFlatPointsHasNoVolume) {
  std::vector<glm::dvec3> points = random_points(20, 1);
  for (glm::dvec3& p : points) p.y = 0;
  EXPECT_NEAR(volume(convex_hull(points)), 0, 1e-12);
  EXPECT_TRUE(convex_hull({}).point.empty());
}

TEST(ShrunkenCorners, LieAsFarInsideAsAskedForOrHalfWay) {
  std::vector<glm::dvec3> cube;
  for (int k = 0; k < 8; ++k) cube.emplace_back(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
  for (const glm::dvec3& corner : shrunken_corners(cube, 0.25)) {
    EXPECT_NEAR(std::max({std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)}), 0.75, 1e-3);
  }
  for (const glm::dvec3& corner : shrunken_corners(cube, 10)) {
    EXPECT_NEAR(std::max({std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)}), 0.5, 1e-3);
  }
}

}  // namespace
}  // namespace pomona
