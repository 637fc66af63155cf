// Triangulations keep segments, also where these cross, overlap and touch.
#include "generator/cut/plane/plane_triangulation.h"

#include <cmath>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/base/cross.h"
#include "generator/base/random.h"

namespace pomona {
namespace {

double area_of(const TriangulatedPlane& plane) {
  double sum = 0;
  for (const glm::uvec3& t : plane.triangle) {
    sum += 0.5 * cross(plane.point[t.y] - plane.point[t.x], plane.point[t.z] - plane.point[t.x]);
  }
  return sum;
}

/// True if the point lies inside the triangle's circumcircle by more than rounding.
bool in_circle(const TriangulatedPlane& plane, const glm::uvec3& t, const glm::dvec2& p) {
  const glm::dvec2 a = plane.point[t.x] - p, b = plane.point[t.y] - p, c = plane.point[t.z] - p;
  return glm::dot(a, a) * cross(b, c) + glm::dot(b, b) * cross(c, a) + glm::dot(c, c) * cross(a, b) > 1e-9;
}

const std::vector<glm::dvec2> frame{{-4, -4}, {4, -4}, {4, 4}, {-4, 4}};

TEST(PlaneTriangulation, CrossingsAndDoublesAreKept) {
  std::vector<glm::dvec2> points = frame;
  for (const glm::dvec2 p : {glm::dvec2(-1, 0), {1, 0}, {0, -1}, {0, 1}, {-1, 0}, {3, 0}}) points.push_back(p);
  const std::vector<PlaneConstraint> constraints{{4, 5}, {6, 7}, {8, 9}, {4, 8}};
  const TriangulatedPlane plane = PlaneTriangulation(points, constraints).state();

  EXPECT_EQ(plane.stand_in[8], 4u);
  EXPECT_EQ(plane.chain[0].size(), 3u);
  EXPECT_EQ(plane.chain[1].size(), 3u);
  EXPECT_EQ(plane.chain[0][1], plane.chain[1][1]);
  EXPECT_EQ(plane.chain[2], (std::vector<std::uint32_t>{4, plane.chain[0][1], 5, 9}));
  EXPECT_TRUE(plane.chain[3].empty());
  EXPECT_NEAR(area_of(plane), 64, 1e-12);
}

TEST(PlaneTriangulation, ConformsToDelaunayAndKeepsWholeWhatIsNotDivisible) {
  // Many random segments, half of them not divisible.
  const RandomStream random({5, 0}, "test/segments");
  std::vector<glm::dvec2> points = frame;
  std::vector<PlaneConstraint> constraints;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const glm::dvec2 p(random.uniform(4 * i) * 4 - 2, random.uniform(4 * i + 1) * 4 - 2);
    const glm::dvec2 d(random.uniform(4 * i + 2) - 0.5, random.uniform(4 * i + 3) - 0.5);
    points.push_back(p);
    points.push_back(p + 2.0 * d);
    constraints.push_back(
        {static_cast<std::uint32_t>(points.size() - 2), static_cast<std::uint32_t>(points.size() - 1), i % 2 == 0});
  }
  PlaneTriangulation triangulation(points, constraints);
  const TriangulatedPlane before = triangulation.state();
  triangulation.conform(1e-4);
  const TriangulatedPlane after = triangulation.state();

  for (std::size_t c = 0; c < constraints.size(); ++c) {
    if (!constraints[c].divisible) {
      EXPECT_EQ(before.chain[c], after.chain[c]);
    }
  }
  EXPECT_GT(after.point.size(), before.point.size());
  EXPECT_NEAR(area_of(after), 64, 1e-9);

  // Every edge but those of whole constraints is a Delaunay edge.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> whole;
  for (std::size_t c = 0; c < constraints.size(); ++c) {
    if (constraints[c].divisible) continue;
    for (std::size_t i = 1; i < after.chain[c].size(); ++i)
      whole.push_back(std::minmax(after.chain[c][i - 1], after.chain[c][i]));
  }
  for (std::size_t t = 0; t < after.triangle.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const std::int32_t other = after.neighbor[t][static_cast<std::size_t>(i)];
      const std::uint32_t p = after.triangle[t][i], q = after.triangle[t][(i + 1) % 3];
      if (other < 0 || std::find(whole.begin(), whole.end(), std::pair(std::min(p, q), std::max(p, q))) != whole.end())
        continue;
      const glm::uvec3& o = after.triangle[static_cast<std::size_t>(other)];
      for (int k = 0; k < 3; ++k) {
        if (o[k] != p && o[k] != q) {
          EXPECT_FALSE(in_circle(after, after.triangle[t], after.point[o[k]]));
        }
      }
    }
  }
}

TEST(PlaneTriangulation, LocatesPointsInTrianglesAsNumbered) {
  PlaneTriangulation triangulation(frame, {});
  const std::vector<glm::dvec2> inside{{1, 2}, {-1, -2}, {0.5, 0}};
  triangulation.insert(inside);
  const TriangulatedPlane plane = triangulation.state();
  const std::vector<glm::dvec2> asked{{0.9, 0.3}, {-3, -3.5}, {9, 9}};
  const std::vector<std::int32_t> found = triangulation.locate(asked);
  EXPECT_EQ(found[2], TriangulatedPlane::none);
  for (std::size_t i = 0; i < 2; ++i) {
    const glm::uvec3& t = plane.triangle[static_cast<std::size_t>(found[i])];
    for (int k = 0; k < 3; ++k) {
      const glm::dvec2 &a = plane.point[t[k]], &b = plane.point[t[(k + 1) % 3]];
      EXPECT_GE(cross(b - a, asked[i] - a), 0);
    }
  }
}

}  // namespace
}  // namespace pomona
