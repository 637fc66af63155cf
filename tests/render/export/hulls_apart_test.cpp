// Hulls of settled pieces, cut apart.
#include "render/export/collision/hulls_apart.h"

#include <gtest/gtest.h>
#include <glm/gtc/quaternion.hpp>

#include "render/export/collision/collision_shape.h"
#include "render/export/collision/hull_bulge.h"
#include "render/export/collision/hull_cut.h"
#include "render/export/collision/settled_hulls.h"
#include "tests/render/export/named_solids.h"

namespace pomona {
namespace {

/// A box about the origin, metres.
ConvexHull box(const glm::vec3& size) {
  std::vector<glm::vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back(0.5f * size * glm::vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  return convex_hull(corners);
}

StandingHulls at(const ConvexHull& hull, const glm::dvec3& place, bool gives_way = true) {
  return {.parts = {&hull}, .place = place, .rotation = {1, 0, 0, 0}, .gives_way = gives_way};
}

/// How deep a corner of the one lies in the other, in the frame of both.
double deepest(const ConvexHull& one, const glm::dvec3& at_one, const ConvexHull& other, const glm::dvec3& at_other) {
  double depth = -1;
  for (const glm::vec3& p : one.position)
    depth = std::max(depth, collision::depth_in(collision::faces_of(other), glm::dvec3(p) + at_one - at_other));
  return depth;
}

TEST(HullsApart, WhatOverlapsIsCutApart) {
  const ConvexHull small = box(glm::vec3(0.02f)), large = box(glm::vec3(0.06f));
  const glm::dvec3 from(0), to(0.037, 0.001, 0.002);  // 3 mm deep
  const std::vector<TrimmedHulls> made = hulls_apart(std::vector{at(large, from), at(small, to)}, {1});
  const ConvexHull& left = made[0].changed ? made[0].parts[0] : large;
  const ConvexHull& right = made[1].changed ? made[1].parts[0] : small;
  EXPECT_LT(deepest(right, to, left, from), 1e-6);
  EXPECT_LT(deepest(left, from, right, to), 1e-6);
  // Of the larger alone it would be 3 of 60 mm, of the smaller 3 of 20.
  EXPECT_LE(2 - volume_of(left) / volume_of(large) - volume_of(right) / volume_of(small), 3.0 / 60 + 1e-6);
}

TEST(HullsApart, DishesStandFast) {
  const ConvexHull slat = box({0.3f, 0.01f, 0.05f}), fruit = box(glm::vec3(0.06f));
  const glm::dvec3 above(0.05, 0.033, 0);  // 2 mm deep
  const std::vector<TrimmedHulls> made =
      hulls_apart(std::vector{at(slat, glm::dvec3(0), false), at(fruit, above)}, {1});
  EXPECT_FALSE(made[0].changed);
  ASSERT_TRUE(made[1].changed);
  EXPECT_LT(deepest(made[1].parts[0], above, slat, glm::dvec3(0)), 1e-6);
  EXPECT_NEAR(volume_of(made[1].parts[0]) / volume_of(fruit), 58.0 / 60, 0.001);
}

TEST(HullsApart, WhatTouchesStaysAsItIs) {
  const ConvexHull cube = box(glm::vec3(0.02f));
  const glm::dquat turned = glm::angleAxis(0.3, glm::normalize(glm::dvec3(1, 2, 3)));
  StandingHulls beside = at(cube, {0.1, 0, 0});
  beside.rotation = turned;
  // Two parts of one body overlap, two bodies touch, one stands by itself, and two dishes lie within each other.
  const StandingHulls twice{.parts = {&cube, &cube}, .place = {0, 0.2, 0}, .rotation = {1, 0, 0, 0}, .gives_way = true};
  const std::vector<StandingHulls> bodies{
      at(cube, {0, 0, 0}),           at(cube, {0.02, 0, 0}),           beside, twice,
      at(cube, {0, -0.2, 0}, false), at(cube, {0.005, -0.2, 0}, false)};
  for (const TrimmedHulls& each : hulls_apart(bodies, {2})) EXPECT_FALSE(each.changed);
}

TEST(HullsApart, NothingIsLostThatAnotherSwallows) {
  const ConvexHull cherry = box(glm::vec3(0.02f)), melon = box(glm::vec3(0.2f));
  const std::vector<TrimmedHulls> made =
      hulls_apart(std::vector{at(melon, glm::dvec3(0), false), at(cherry, {0, 0, 0})}, {1});
  EXPECT_FALSE(made[1].changed) << "no plane leaves a third of it";
}

TEST(SettledHulls, PiecesLeaveRoomForEachOther) {
  Scene scene = named::settled_balls();
  std::vector<std::vector<ConvexHull>> parts;
  for (const Solid& solid : scene.solids) parts.push_back(collision_parts(solid, 1));
  const auto place = [&](std::size_t i) { return scene.instances[i].pose.translation; };
  EXPECT_GT(deepest(parts[1][0], place(1), parts[0][0], place(0)), 1e-3);
  const auto own = settled_hulls(scene, parts, {2});
  for (std::size_t i = 0; i < 4; i += 2) {
    ASSERT_EQ(own[i].size() + own[i + 1].size(), 2u);
    EXPECT_LT(deepest(own[i + 1][0], place(i + 1), own[i][0], place(i)), 1e-4);
  }
  // What is only cut has the shapes that it takes along.
  for (Solid& solid : scene.solids) solid.origin.entry.clear();
  for (const auto& none : settled_hulls(scene, parts, {2})) EXPECT_TRUE(none.empty());
}

TEST(HullCut, TheTwoSidesAddUp) {
  const ConvexHull hull = box({0.02f, 0.03f, 0.05f});
  const std::vector<glm::dvec3> corners(hull.position.begin(), hull.position.end());
  const CuttingPlane plane{glm::normalize(glm::dvec3(1, -2, 0.5)), 0.003};
  const double before = volume_before(corners, hull.triangle, plane);
  EXPECT_GT(before, 0);
  EXPECT_NEAR(before + volume_before(corners, hull.triangle, {-plane.normal, -plane.offset}), volume_of(hull), 1e-15);
  EXPECT_NEAR(volume_of(behind(hull, plane, 64)), volume_of(hull) - before, 1e-11);
}

}  // namespace
}  // namespace pomona
