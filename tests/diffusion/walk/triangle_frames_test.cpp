#include "generator/diffusion/walk/triangle_frames.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/shapes/seeded_fruit.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

glm::dvec3 vector_of(const float (&from)[3][FrameGroup::size], int lane) {
  return {from[0][lane], from[1][lane], from[2][lane]};
}

TriangleFrames frames_of(const DiffusionSurfaces& surfaces) {
  return make_triangle_frames(surfaces, make_surface_tree(surfaces));
}

TEST(TriangleFrames, HoldTheCornersOfTheirTriangles) {
  const DiffusionSurfaces fruit = shapes::tilted(shapes::torus(0.3, 0.1, 9, 7));
  const TriangleFrames frames = frames_of(fruit);
  for (const FrameGroup& group : frames.groups) {
    for (int lane = 0; lane < FrameGroup::size; ++lane) {
      const glm::dvec3 origin = vector_of(group.origin, lane), u = vector_of(group.u, lane),
                       v = vector_of(group.v, lane), w = vector_of(group.w, lane);
      const double length = group.length[lane], apex_u = group.apex_u[lane], apex_v = group.apex_v[lane];
      const glm::dvec3 end = origin + length * u, apex = origin + apex_u * u + apex_v * v;
      // In some turn of its corners, the longest edge first.
      bool is_found = false;
      const auto corner = corners(fruit, group.triangle[lane]);
      for (std::size_t k = 0; k < 3; ++k) {
        is_found = is_found || (glm::distance(frames.normalized(corner[k]), origin) < 1e-6 &&
                                glm::distance(frames.normalized(corner[(k + 1) % 3]), end) < 1e-6 &&
                                glm::distance(frames.normalized(corner[(k + 2) % 3]), apex) < 1e-6);
      }
      EXPECT_TRUE(is_found) << group.triangle[lane];
      EXPECT_GE(length, glm::distance(origin, apex) - 1e-6);
      EXPECT_GE(length, glm::distance(end, apex) - 1e-6);
      EXPECT_LT(glm::distance(glm::cross(u, v), w), 1e-6);
      EXPECT_NEAR(glm::length(u), 1, 1e-6);
      EXPECT_GT(glm::dot(glm::cross(end - origin, apex - origin), w), 0) << "fronts look along w";
      EXPECT_NEAR(group.per_left[lane] * glm::dot(apex - origin, apex - origin), 1, 1e-4);
      EXPECT_NEAR(group.per_right[lane] * glm::dot(apex - end, apex - end), 1, 1e-4);
    }
  }
}

TEST(TriangleFrames, HoldEveryTriangleAndRepeatTheLast) {
  const DiffusionSurfaces ball = shapes::moved(shapes::sphere(0.3, 3), {5, -2, 1});
  const SurfaceTree tree = make_surface_tree(ball);
  DiffusionSurfaces few = ball;
  few.triangle.resize(11);
  few.surface.resize(11);
  few.front_part.resize(11);
  few.back_part.resize(11);
  const TriangleFrames frames = frames_of(few);
  ASSERT_EQ(frames.groups.size(), 2u);
  std::vector<std::uint32_t> held;
  for (const FrameGroup& group : frames.groups) held.insert(held.end(), group.triangle, group.triangle + 8);
  for (std::size_t i = 11; i < 16; ++i) EXPECT_EQ(held[i], held[10]);
  held.resize(11);
  std::sort(held.begin(), held.end());
  for (std::uint32_t t = 0; t < 11; ++t) EXPECT_EQ(held[t], t);
}

TEST(TriangleFrames, LieWithinTheUnitBall) {
  const DiffusionSurfaces fruit = shapes::moved(shapes::seeded_fruit(), {3, 1, -2});
  const TriangleFrames frames = frames_of(fruit);
  double farthest = 0;
  for (std::uint32_t t = 0; t < fruit.triangle_count(); ++t) {
    for (const glm::dvec3& corner : corners(fruit, t))
      farthest = std::max(farthest, glm::length(frames.normalized(corner)));
  }
  EXPECT_NEAR(farthest, 1, 1e-12);
  EXPECT_LT(glm::distance(frames.middle, bounds_of(fruit).center()), 1e-12);
}

}  // namespace
}  // namespace pomona
