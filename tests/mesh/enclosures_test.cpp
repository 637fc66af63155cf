#include "generator/mesh/enclosures.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/mesh/random_points.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

using Windings = std::vector<std::pair<std::uint32_t, int>>;

void append(std::vector<Enclosures::Triangle>& triangles, const DiffusionSurfaces& surfaces, std::uint32_t mesh) {
  for (const glm::uvec3& t : surfaces.triangle) {
    triangles.push_back(
        {{glm::dvec3(surfaces.position[t.x]), glm::dvec3(surfaces.position[t.y]), glm::dvec3(surfaces.position[t.z])},
         mesh});
  }
}

TEST(Enclosures, TellWhichBallsAPointIsIn) {
  std::vector<Enclosures::Triangle> triangles;
  append(triangles, shapes::sphere(1, 16), 3);
  append(triangles, shapes::turned_inside_out(shapes::sphere(0.6, 16)), 5);
  append(triangles, shapes::moved(shapes::sphere(1, 16), {1, 0, 0}), 1);
  const Enclosures balls(triangles);
  for (const glm::dvec3& p : random_points(500, 2)) {
    const double from_first = glm::length(p), from_other = glm::distance(p, glm::dvec3(1, 0, 0));
    const auto is_close = [](double distance, double radius) { return distance > 0.97 * radius && distance < radius; };
    if (is_close(from_first, 1) || is_close(from_first, 0.6) || is_close(from_other, 1)) continue;
    Windings expected;
    if (from_other < 1) expected.emplace_back(1, 1);
    if (from_first < 1) expected.emplace_back(3, 1);
    if (from_first < 0.6) expected.emplace_back(5, -1);
    EXPECT_EQ(balls.around(p), expected);
  }
}

TEST(Enclosures, CountHowOftenAMeshWindsAround) {
  std::vector<Enclosures::Triangle> triangles;
  append(triangles, shapes::box({-1, -1, -1}, {1, 1, 1}, 2), 0);
  append(triangles, shapes::box({-2, -2, -2}, {2, 2, 2}, 2), 0);
  const Enclosures boxes(triangles);
  EXPECT_EQ(boxes.around({0, 0, 0}), (Windings{{0, 2}})) << "straight below edges and vertices";
  EXPECT_EQ(boxes.around({0, 1.5, 0}), (Windings{{0, 1}}));
  EXPECT_EQ(boxes.around({0, 2.5, 0}), Windings{});
  EXPECT_EQ(boxes.around({0, -2.5, 0}), Windings{}) << "in below, out above";
}

TEST(Enclosures, OfNothingEncloseNothing) { EXPECT_TRUE(Enclosures({}).around({0, 0, 0}).empty()); }

}  // namespace
}  // namespace pomona
