#include "generator/mesh/triangle_distance.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/mesh/random_points.h"

namespace pomona {
namespace {

std::vector<TriangleCorners> random_triangles(std::size_t count, double size, std::uint64_t seed) {
  const std::vector<glm::dvec3> points = random_points(3 * count, size, seed);
  std::vector<TriangleCorners> triangles;
  for (std::size_t i = 0; i < count; ++i) triangles.push_back({points[3 * i], points[3 * i + 1], points[3 * i + 2]});
  return triangles;
}

/// Places all over a triangle, its corners and edges among them.
std::vector<glm::dvec3> places_on(const TriangleCorners& t, int steps) {
  std::vector<glm::dvec3> places;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      const double u = static_cast<double>(i) / steps, v = static_cast<double>(j) / steps;
      places.push_back(u * t[0] + v * t[1] + (1 - u - v) * t[2]);
    }
  }
  return places;
}

double longest_edge(const TriangleCorners& t) {
  return std::max({glm::distance(t[0], t[1]), glm::distance(t[1], t[2]), glm::distance(t[2], t[0])});
}

TEST(NearestOnTriangle, IsNearerThanAnyPlaceTriedAndHardlyNearer) {
  const std::vector<glm::dvec3> points = random_points(40, 3, 2);
  for (const TriangleCorners& t : random_triangles(40, 1, 3)) {
    for (const glm::dvec3& p : points) {
      double tried = 1e9;
      for (const glm::dvec3& place : places_on(t, 20)) tried = std::min(tried, glm::distance(p, place));
      const double found = glm::distance(p, nearest_on_triangle(p, t));
      EXPECT_LE(found, tried * (1 + 1e-12));
      EXPECT_GE(found, tried - longest_edge(t) / 20) << "on the triangle, not only in its plane";
    }
  }
}

TEST(NearestOnTriangle, OfLinesAndPointsIsOnThem) {
  const TriangleCorners line{glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(2, 0, 0)};
  EXPECT_NEAR(glm::distance(nearest_on_triangle({1.5, 1, 0}, line), {1.5, 0, 0}), 0, 1e-12);
  EXPECT_EQ(nearest_on_triangle({5, 1, 0}, line), glm::dvec3(2, 0, 0));
  const glm::dvec3 at(1, 2, 3);
  EXPECT_EQ(nearest_on_triangle({5, 1, 0}, {at, at, at}), at);
}

TEST(NearestWeights, AreThoseOfTheNearestPointInEitherPrecision) {
  const std::vector<glm::dvec3> points = random_points(40, 3, 5);
  for (const TriangleCorners& t : random_triangles(40, 1, 6)) {
    for (const glm::dvec3& p : points) {
      const glm::dvec3 w = nearest_weights(p, t[0], t[1], t[2]);
      EXPECT_NEAR(w.x + w.y + w.z, 1, 1e-12);
      EXPECT_GE(std::min({w.x, w.y, w.z}), -1e-12);
      const glm::dvec3 place = w.x * t[0] + w.y * t[1] + w.z * t[2];
      EXPECT_LT(glm::distance(place, nearest_on_triangle(p, t)), 1e-9);
      const glm::dvec3 single(nearest_weights(glm::vec3(p), glm::vec3(t[0]), glm::vec3(t[1]), glm::vec3(t[2])));
      const glm::dvec3 there = single.x * t[0] + single.y * t[1] + single.z * t[2];
      EXPECT_NEAR(glm::distance(p, there), glm::distance(p, place), 1e-3);
    }
  }
}

TEST(NearestOnSegments, IsNearerThanAnyPairTried) {
  const std::vector<glm::dvec3> ends = random_points(400, 1, 7);
  for (std::size_t i = 0; i < ends.size(); i += 4) {
    const glm::dvec3 &a = ends[i], &b = ends[i + 1], &c = ends[i + 2], &d = ends[i + 3];
    const auto [p, q] = nearest_on_segments(a, b, c, d);
    double tried = 1e9;
    for (int j = 0; j <= 30; ++j) {
      for (int k = 0; k <= 30; ++k)
        tried = std::min(tried, glm::distance(a + (b - a) * (j / 30.0), c + (d - c) * (k / 30.0)));
    }
    EXPECT_LE(glm::distance(p, q), tried * (1 + 1e-12));
    EXPECT_NEAR(glm::distance(a, p) + glm::distance(p, b), glm::distance(a, b), 1e-9) << "on the segment";
    EXPECT_NEAR(glm::distance(c, q) + glm::distance(q, d), glm::distance(c, d), 1e-9);
  }
}

TEST(NearestOnTriangles, IsTheSamePointWhereTheyCrossAndElseNearerThanAnyTried) {
  int crossing = 0, apart = 0;
  const std::vector<TriangleCorners> triangles = random_triangles(60, 1, 8);
  for (std::size_t i = 0; i + 1 < triangles.size(); ++i) {
    const TriangleCorners &a = triangles[i], &b = triangles[i + 1];
    const auto [p, q] = nearest_on_triangles(a, b);
    EXPECT_LT(glm::distance(p, nearest_on_triangle(p, a)), 1e-9);
    EXPECT_LT(glm::distance(q, nearest_on_triangle(q, b)), 1e-9);
    double tried = 1e9;
    for (const glm::dvec3& place : places_on(a, 25))
      tried = std::min(tried, glm::distance(place, nearest_on_triangle(place, b)));
    EXPECT_LE(glm::distance(p, q), tried * (1 + 1e-12));
    EXPECT_GE(glm::distance(p, q), tried - longest_edge(a) / 25);
    (p == q ? crossing : apart) += 1;
  }
  EXPECT_GT(crossing, 5);
  EXPECT_GT(apart, 5);
}

}  // namespace
}  // namespace pomona
