// [axis], loops as stops along it, and `off`.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/base/units.h"
#include "tests/template/plum.h"

namespace pomona {
namespace {

const std::string pit = R"(
[[surface]]
name = "pit"
type = "around-axis"
vertical = "M 0 -10 C 4 -10, 4 -20, 0 -20"
front = { part = "flesh", color = "#d89a2a" }
back = { part = "stone", color = "#7a4a20" }
)";

TEST(ReadAxis, a_line_leans_as_it_is_drawn) {
  // A twelfth of a circle, from upright to a third of the way down; SVG's y runs downwards.
  const Template plum = plum_and("[axis]\nline = \"M 0 0 A 100 100 0 0 1 13.4 -50\"\ntwist = [[0.0, 0], [1.0, 90]]\n");
  ASSERT_FALSE(plum.bend.line.empty());
  EXPECT_NEAR(plum.bend.lean(-1), 0, 0.03);
  EXPECT_NEAR(plum.bend.lean(0), pi / 12, 0.01);
  EXPECT_NEAR(plum.bend.lean(1), pi / 6, 0.03);
  EXPECT_NEAR(plum.bend.turning(0), pi / 12, 0.02);
  EXPECT_NEAR(plum.bend.twist(0.5), pi / 4, 1e-6);
  EXPECT_TRUE(plum.bend.leans());
}

TEST(ReadAxis, without_it_nothing_is_bent) { EXPECT_TRUE(plum_and("").bend.is_straight()); }

TEST(ReadAxis, a_bend_adds_to_the_line) {
  const Template plum = plum_and("[axis]\nline = \"M 0 0 L 0 -40\"\n[bend]\nangle = 20\n");
  EXPECT_NEAR(plum.bend.lean(1), radians(10), 1e-9);
}

TEST(ReadAxis, stops_have_the_size_of_the_first) {
  const Template plum = plum_and(pit + R"(horizontal = [
  [0.0, "M 4 0 L 0 4 L -4 0 L 0 -4 Z"],
  [0.5, "M 30 0 L 0 30 L -30 0 L 0 -30 Z"],
]
off = [[0.0, ["0mm", "0mm"]], [0.5, ["2mm", "-1mm"]]]
)");
  const SurfaceSketch& stone = plum.surfaces.back();
  EXPECT_EQ(stone.stops, (std::vector<double>{0, 0.5}));
  ASSERT_EQ(stone.horizontal.size(), 2u);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(glm::distance(stone.horizontal[0].points[i], stone.horizontal[1].points[i]), 0, 1e-12);
  EXPECT_NEAR(stone.off.x(0.25), 0.001, 1e-12);
  EXPECT_NEAR(stone.off.z(1), -0.001, 1e-12);
}

TEST(ReadAxis, off_may_be_the_same_everywhere) {
  const Template plum = plum_and(pit + "off = [\"1mm\", \"0mm\"]\n");
  EXPECT_EQ(plum.surfaces.back().off.x(0.7), 0.001);
  EXPECT_TRUE(plum.surfaces.front().off.is_zero());
}

TEST(ReadAxis, mistakes_are_found) {
  constexpr std::array mistakes{
      Mistake{"[axis]\nline = \"M 0 0 L 0 -1 L 1 -1 Z\"\n", 2, 8, "is no line"},
      Mistake{"[axis]\nline = \"M 0 0 C 0 -60, 60 -60, 60 0\"\n", 1, 1, "folds the fruit where it is wide"},
      Mistake{"[axis]\nlien = \"M 0 0 L 0 -9\"\n", 2, 1, "unknown key \"lien\""},
      Mistake{"[axis]\ntwist = [[0.0, 4000]]\n", 2, 16, "must lie between"},
      Mistake{"[axis]\nline = \"M 0 0 L 0 -9\"\n[variation]\nbend = { angle = 3, around = true }\n", 4, 30,
              "but the axis is drawn"},
  };
  expect_found(mistakes);
}

TEST(ReadAxis, mistakes_of_stops_and_off_are_found) {
  const auto expect = [](const std::string& more, int line, int column, const char* message) {
    const Mistake mistake{more.c_str(), line, column, message};
    expect_found(std::span(&mistake, 1));
  };
  expect(pit + "horizontal = [[0.2, \"M 9 0 L 0 9 L -9 0 L 0 -9 Z\"], [0.1, \"M 9 0 L 0 9 L -9 0 L 0 -9 Z\"]]\n", 8, 54,
         "does not ascend");
  expect(pit + "horizontal = [[0.2, \"M 9 0 L 8 9 L 7 0 Z\"]]\n", 8, 21, "does not surround the axis");
  expect(pit + "horizontal = []\n", 8, 14, "has no stops");
  expect(pit + "off = [[0.0, \"1mm\"]]\n", 8, 14, "must be an array");
  expect(pit + "off = [\"1mm\"]\n", 8, 7, "must be two lengths");
  expect(pit + "off = [\"0mm\", [[0.0, \"1mm\"], [1.0, \"2mm\"]]]\n", 8, 7, "has a ramp for one of its lengths");
}

}  // namespace
}  // namespace pomona
