#include "tests/shapes/shapes.h"

#include <gtest/gtest.h>

#include "generator/base/units.h"

namespace pomona::shapes {
namespace {

TEST(Shapes, VolumesAndAreasAreThoseOfTheSolids) {
  EXPECT_NEAR(signed_volume(sphere(1, 32)), 4 * pi / 3, 0.01);
  EXPECT_NEAR(area(sphere(1, 32)), 4 * pi, 0.02);
  EXPECT_NEAR(signed_volume(box({-1, 0, 0}, {1, 3, 1}, 4)), 6, 1e-5);
  EXPECT_NEAR(area(open_sheet(2, 0.5, 3)), 4, 1e-5);
  EXPECT_NEAR(signed_volume(torus(1, 0.25, 96, 48)), 2 * pi * pi * 0.0625, 0.005);
}

TEST(Shapes, TurningChangesTheSignOrNothing) {
  const double volume = signed_volume(sphere(1, 8));
  EXPECT_NEAR(signed_volume(tilted(sphere(1, 8))), volume, 1e-5);
  EXPECT_NEAR(signed_volume(turned_inside_out(sphere(1, 8))), -volume, 1e-9);
}

TEST(Shapes, FrontOfASheetIsUp) {
  const DiffusionSurfaces sheet = open_sheet(1, 0);
  const glm::uvec3 t = sheet.triangle[0];
  const glm::vec3 a = sheet.position[t.x], b = sheet.position[t.y], c = sheet.position[t.z];
  EXPECT_GT((b - a).z * (c - a).x - (b - a).x * (c - a).z, 0);
}

TEST(Shapes, SkinsFaceAir) {
  const DiffusionSurfaces ball = hollow_ball(1, 0.5, 4);
  EXPECT_TRUE(ball.is_hidden(0, SideOf::front));
  EXPECT_TRUE(ball.is_hidden(ball.triangle_count() - 1, SideOf::back));
}

}  // namespace
}  // namespace pomona::shapes
