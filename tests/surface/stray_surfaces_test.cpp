#include "generator/surface/stray_surfaces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

using namespace shapes;

std::vector<std::string> warnings_of(const DiffusionSurfaces& surfaces) {
  return stray_warnings(surfaces, find_bodies(surfaces));
}

DiffusionSurfaces ball_with_core_at(double x) {
  Paint core;
  core.name = "core";
  return joined(sphere(1, 16, skin_paint()), moved(sphere(0.4, 16, core), {x, 0, 0}));
}

TEST(StraySurfaces, OfWhatLiesWithinAreNone) {
  EXPECT_TRUE(warnings_of(ball_with_core_at(0)).empty());
  EXPECT_TRUE(warnings_of(hollow_ball(1, 0.5, 8)).empty());
  EXPECT_TRUE(warnings_of(open_sheet(1, 0, 2, skin_paint())).empty()) << "nothing is inside of what is open";
}

TEST(StraySurfaces, AreToldByNameAndShare) {
  // A ball of radius r around a point of the skin of a ball of radius R has the share (1 + r / 2R) / 2 of its area
  // outside, by the law of cosines.
  EXPECT_THAT(warnings_of(ball_with_core_at(1)),
              testing::ElementsAre(testing::ContainsRegex("surface \"core\": 6[0-3] % of it lies outside")));
  EXPECT_THAT(warnings_of(ball_with_core_at(2)), testing::ElementsAre(testing::HasSubstr("100 %")));
}

TEST(StraySurfaces, MayTouchTheSkin) { EXPECT_TRUE(warnings_of(ball_with_core_at(0.61)).empty()); }

}  // namespace
}  // namespace pomona
