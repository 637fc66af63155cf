#include "generator/mesh/polygon_triangles.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace pomona {
namespace {

using Corners = std::vector<glm::dvec3>;

/// The area of all triangles, each counted positive. It equals the polygon's only if no triangle leaves the polygon.
double area_of(const Corners& corners, const std::vector<glm::uvec3>& triangles) {
  double area = 0;
  for (const glm::uvec3& t : triangles)
    area += glm::length(glm::cross(corners[t.y] - corners[t.x], corners[t.z] - corners[t.x])) / 2;
  return area;
}

/// A C of three unit squares by seven: 11 squares.
const Corners c_shape{{4, 1, 0}, {1, 1, 0}, {1, 3, 0}, {4, 3, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}, {4, 0, 0}};

/// The same polygon, turned in space and moved.
Corners tilted(Corners corners, double by) {
  for (glm::dvec3& p : corners) {
    const double c = std::cos(by), s = std::sin(by);
    p = {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
    p = {p.x, c * p.y - s * p.z, s * p.y + c * p.z};
    p += glm::dvec3(7, -3, 5);
  }
  return corners;
}

TEST(PolygonTriangles, AConvexPolygonIsAFan) {
  const Corners square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(polygon_triangles(square), (std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(PolygonTriangles, AConcaveOneIsFilledFromWhereverItBeginsAndHoweverItLies) {
  for (std::size_t start = 0; start < c_shape.size(); ++start) {
    for (const double by : {0.0, 0.4, 2.0, 4.5}) {
      Corners corners(c_shape.begin() + static_cast<std::ptrdiff_t>(start), c_shape.end());
      corners.insert(corners.end(), c_shape.begin(), c_shape.begin() + static_cast<std::ptrdiff_t>(start));
      corners = tilted(corners, by);
      const auto triangles = polygon_triangles(corners);
      ASSERT_TRUE(triangles.has_value());
      EXPECT_EQ(triangles->size(), corners.size() - 2);
      EXPECT_NEAR(area_of(corners, *triangles), 10, 1e-9);
      // All triangles turn the same way as the polygon.
      glm::dvec3 normal(0);
      for (std::size_t k = 2; k < corners.size(); ++k)
        normal += glm::cross(corners[k - 1] - corners[0], corners[k] - corners[0]);
      for (const glm::uvec3& t : *triangles)
        EXPECT_GT(glm::dot(normal, glm::cross(corners[t.y] - corners[t.x], corners[t.z] - corners[t.x])), 0);
    }
  }
}

TEST(PolygonTriangles, ABridgeLeadsToAHole) {
  const Corners ring{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {0, 0, 0},
                     {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}};
  const auto triangles = polygon_triangles(ring);
  ASSERT_TRUE(triangles.has_value());
  EXPECT_NEAR(area_of(ring, *triangles), 8, 1e-12);
}

TEST(PolygonTriangles, CornersOnALineStay) {
  const Corners corners{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 1, 0}, {0, 2, 0}};
  const auto triangles = polygon_triangles(corners);
  ASSERT_TRUE(triangles.has_value());
  std::vector<int> used(corners.size(), 0);
  for (const glm::uvec3& t : *triangles)
    for (int k = 0; k < 3; ++k) ++used[t[k]];
  for (const int times : used) EXPECT_GT(times, 0);
  EXPECT_NEAR(area_of(corners, *triangles), 3, 1e-12);
}

TEST(PolygonTriangles, WhatCrossesItselfIsNone) {
  EXPECT_FALSE(polygon_triangles(Corners{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_FALSE(polygon_triangles(Corners{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 1, 0}}));
}

TEST(PolygonTriangles, WhatHasNoAreaIsAFan) {
  EXPECT_EQ(polygon_triangles(Corners{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 0}})->size(), 2u);
  EXPECT_EQ(polygon_triangles(Corners(5, glm::dvec3(1)))->size(), 3u);
}

}  // namespace
}  // namespace pomona
