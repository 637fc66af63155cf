#include "generator/diffusion/walk/walks_from_point.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

shapes::Paint evenly(float shade, const std::string& part) {
  shapes::Paint paint;
  paint.front = paint.back = Color(shade);
  paint.front_part = paint.back_part = part;
  return paint;
}

/// White in a black shell: 1 / r in between.
DiffusionSurfaces shell() { return shapes::nested_spheres(1, 0.4, 12, evenly(0, "skin"), evenly(1, "core")); }

TEST(WalksFromPoint, KeepToTheStandardErrorTheyAreAskedFor) {
  const DiffusionSurfaces surfaces = shell();
  const WalkGround ground(surfaces, {1});
  const glm::vec3 point(0.5f, 0.3f, -0.2f);
  const double truth = (1 / glm::length(glm::dvec3(point)) - 1) / 1.5;
  std::uint32_t last = 0;
  for (const double asked : {8.0, 4.0, 2.0}) {
    const WalkedColor walked = walks_from_point(ground, point, {.standard_error = asked});
    EXPECT_LE(walked.standard_error, asked);
    EXPECT_GT(walked.standard_error, 0.5 * asked);
    EXPECT_NEAR(walked.color.r, truth, 4 * asked / 255 + 0.02);
    EXPECT_GT(walked.walks, 2 * last) << "four times as many for half the error";
    // No more walks than draws of black and white with this probability would need.
    EXPECT_LT(walked.walks, 1.1 * truth * (1 - truth) * (255 / asked) * (255 / asked) + 200);
    EXPECT_EQ(walked.misses, 0u);
    last = walked.walks;
  }
}

TEST(WalksFromPoint, BeginNowhereOnASurface) {
  const DiffusionSurfaces surfaces = shell();
  const WalkGround ground(surfaces, {1});
  const WalkedColor walked = walks_from_point(ground, surfaces.position[5], {});
  EXPECT_EQ(walked.walks, 0u);
  EXPECT_EQ(walked.standard_error, 0);
  EXPECT_EQ(walked.color, Color(0));
}

TEST(WalksFromPoint, DependOnThePlaceAndTheSeedAlone) {
  const DiffusionSurfaces surfaces = shell();
  const WalkGround ground(surfaces, {1});
  const WalkOptions options{.standard_error = 8};
  const WalkedColor first = walks_from_point(ground, {0, 0.6f, 0}, options);
  EXPECT_EQ(walks_from_point(ground, {0, 0.6f, 0}, options).color, first.color);
  EXPECT_EQ(walks_from_point(ground, {-0.0f, 0.6f, -0.0f}, options).color, first.color) << "-0 and 0 are one place";
  EXPECT_NE(walks_from_point(ground, {0, 0.6f, 0}, {.standard_error = 8, .seed = 1}).color, first.color);
  // Rotations map these places around the core to each other: the exact value is the same, the draws differ.
  EXPECT_NE(walks_from_point(ground, {0.6f, 0, 0}, options).color, first.color);
}

TEST(WalksFromPoint, NameThePartThatMostMeet) {
  const DiffusionSurfaces surfaces = shell();
  const WalkGround ground(surfaces, {1});
  for (const auto& [x, part] : {std::pair{0.45f, "core"}, {0.93f, "skin"}}) {
    const WalkedColor walked = walks_from_point(ground, {x, 0.01f, 0.02f}, {.standard_error = 8});
    EXPECT_EQ(surfaces.part_names[static_cast<std::size_t>(walked.part)], part);
  }
}

TEST(WalksFromPoint, EscapeFromClosedSurfacesOnlyOnTheirWayIn) {
  // Walks from far away are counted from where they first come within 1.02 radii; one in 51 of them turns back there.
  // They meet only the front.
  shapes::Paint paint = evenly(0.25f, "peel");
  paint.back = Color(1);
  const DiffusionSurfaces ball = shapes::sphere(0.1, 12, paint);
  const WalkGround ground(ball, {1});
  const WalkedColor walked = walks_from_point(ground, {0.3f, 0, 0}, {.standard_error = 0.5});
  EXPECT_NEAR(walked.color.r, 0.25, 1e-6);
  ASSERT_GT(walked.walks, 300u);
  const double share = 1 - static_cast<double>(walked.misses) / walked.walks;
  EXPECT_NEAR(share, 1 / 1.02, 4 * std::sqrt(0.02 / walked.walks) + 0.005);
}

/// Between two small balls far from each other hardly a walk meets anything, so that only one of both halves may have a
/// colour.
TEST(WalksFromPoint, OfWhichFewMeetAnythingHaveTheColorOfThoseThatDo) {
  shapes::Paint paint = evenly(0.5f, "peel");
  paint.back = Color(0);
  const DiffusionSurfaces ball = shapes::sphere(0.004, 3, paint);
  const DiffusionSurfaces two = joined(shapes::moved(ball, {1, 0, 0}), shapes::moved(ball, {-1, 0, 0}));
  const WalkGround ground(two, {1});
  int of_one_half = 0;
  for (int i = 0; i < 60; ++i) {
    const glm::vec3 point(0, 0.005f * static_cast<float>(i), 0.1f);
    const WalkedColor walked = walks_from_point(ground, point, {.standard_error = 1, .max_walks = 96});
    EXPECT_NEAR(walked.color.r, 0.5, 1e-6) << i;
    of_one_half += walked.walks - walked.misses == 1;
  }
  EXPECT_GT(of_one_half, 10);
}

TEST(WalksFromPoint, AreNoMoreThanTheyMayBe) {
  const DiffusionSurfaces surfaces = shell();
  const WalkGround ground(surfaces, {1});
  const WalkedColor walked = walks_from_point(ground, {0.5f, 0.3f, -0.2f}, {.standard_error = 0.01, .max_walks = 1200});
  EXPECT_LE(walked.walks, 1200u + 48) << "in whole batches";
  EXPECT_GT(walked.standard_error, 0.01);
}

}  // namespace
}  // namespace pomona
