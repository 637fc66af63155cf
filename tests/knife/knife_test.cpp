// Knives: what users may write, and which planes and cells result.
#include "generator/knife/knife.h"
#include "generator/knife/knife_kinds.h"
#include "generator/knife/knife_planes.h"
#include "generator/knife/parse_knife.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/units.h"

namespace pomona {
namespace {

const Box<double> box{{-0.05, 0, -0.04}, {0.05, 0.08, 0.04}};

int cell_at(const KnifePlanes& knife, const glm::dvec3& p) {
  KnifeSides sides;
  for (std::size_t i = 0; i < knife.planes.size(); ++i) {
    sides = knife.seen(sides, i, glm::dot(knife.planes[i].normal, p) >= knife.planes[i].offset);
  }
  return knife.cell(sides);
}

TEST(Knife, BadOnesAreUsageErrorsThatSayWhatAKnifeIs) {
  for (const char* text : {"",
                           "saw",
                           "half:2",
                           "across ",
                           "plane:1,2,3",
                           "plane:0,0,0,1",
                           "plane:1,2,x,1",
                           "plane:1,0,0,1kg",
                           "plane:nan,0,0,1",
                           "wedges",
                           "wedges:1",
                           "wedges:0",
                           "wedges:361",
                           "wedges:-3",
                           "wedges:2.5",
                           "slices:",
                           "slices:1",
                           "slices:0mm",
                           "slices:-4mm",
                           "slices:99999",
                           "slices:1e999m",
                           "slices:8,along=w",
                           "slices:8,along=xy",
                           "slices:8,x",
                           "slices:8,along=x,along=z",
                           "dice",
                           "dice:1",
                           "dice:0mm",
                           "dice:1000000",
                           "sticks:-2mm"}) {
    SCOPED_TRACE(text);
    try {
      parse_knife(text);
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::usage);
      const std::string kind(text, std::strcspn(text, ":"));
      const auto& kinds = knife_kinds();
      const bool is_known = std::any_of(kinds.begin(), kinds.end(), [&](const KnifeKind& k) { return k.name == kind; });
      // The hint says how a known kind is written, or names all kinds, or says something more useful.
      const std::string& hint = error.diagnostics().at(0).hint;
      if (is_known)
        EXPECT_THAT(hint, testing::AnyOf(testing::HasSubstr("it is written " + kind), testing::HasSubstr("above 0")));
      else
        EXPECT_THAT(hint, testing::HasSubstr("wedges:N"));
    }
  }
}

TEST(Knife, PlaneHasAUnitNormalAndADistanceInAnyUnit) {
  const auto plane = [](const char* text) {
    return std::get<PlaneKnife>(std::get<PlaneCut>(parse_knife(text).cut)).plane;
  };
  EXPECT_NEAR(plane("plane:0,3,4,2cm").normal.y, 0.6, 1e-15);
  EXPECT_NEAR(plane("plane:0,3,4,2cm").normal.z, 0.8, 1e-15);
  EXPECT_DOUBLE_EQ(plane("plane:0,3,4,2cm").offset, 0.02);
  EXPECT_NEAR(plane("plane:0,1e-300,0,1").normal.y, 1, 1e-15);
}

TEST(Knife, WedgesAreTheSectorsOfATurn) {
  for (const int n : {2, 3, 4, 5, 6, 7, 12, 359, 360}) {
    SCOPED_TRACE(n);
    const KnifePlanes knife = planes_of(parse_knife("wedges:" + std::to_string(n)), box);
    EXPECT_EQ(knife.cell_count(), n);
    for (int i = 0; i < n; ++i) {
      for (const double share : {0.02, 0.5, 0.98}) {
        const double angle = 2 * pi * (i + share) / n;  // from +X towards -Z
        EXPECT_EQ(cell_at(knife, {std::cos(angle), 0.3, -std::sin(angle)}), i);
      }
    }
  }
}

TEST(Knife, QuarterTurnsLieOnTheAxes) {
  const KnifePlanes knife = planes_of(parse_knife("wedges:4"), box);
  ASSERT_EQ(knife.planes.size(), 2u);
  EXPECT_EQ(knife.planes[0].normal, glm::dvec3(0, 0, -1));
  EXPECT_EQ(knife.planes[1].normal, glm::dvec3(-1, 0, 0));
}

TEST(Knife, SlicesAreCentred) {
  const KnifePlanes eight = planes_of(parse_knife("slices:8"), box);
  ASSERT_EQ(eight.planes.size(), 7u);
  EXPECT_NEAR(eight.planes[3].offset, 0.04, 1e-15);
  EXPECT_NEAR(eight.planes[0].offset, 0.01, 1e-15);

  // 80 mm hold eight slices of 9 mm, and 4 mm are left over at either end.
  const KnifePlanes thick = planes_of(parse_knife("slices:9mm"), box);
  ASSERT_EQ(thick.planes.size(), 9u);
  EXPECT_NEAR(thick.planes[0].offset, 0.004, 1e-15);
  EXPECT_NEAR(thick.planes[8].offset, 0.076, 1e-15);

  // Where they fit exactly, no plane lies on the ends.
  EXPECT_EQ(planes_of(parse_knife("slices:10mm"), box).planes.size(), 7u);
  EXPECT_THROW(planes_of(parse_knife("slices:0.001mm"), box), Error);

  // Across another axis, by the extent along it.
  const KnifePlanes upright = planes_of(parse_knife("slices:4,along=x"), box);
  ASSERT_EQ(upright.planes.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(upright.planes[i].normal, glm::dvec3(1, 0, 0));
    EXPECT_NEAR(upright.planes[i].offset, box.low.x + (i + 1) * box.size().x / 4, 1e-15);
  }
}

TEST(Knife, DiceAndSticksAreSlicesInSeveralDirections) {
  const KnifePlanes dice = planes_of(parse_knife("dice:4"), box);
  EXPECT_EQ(dice.planes.size(), 9u);
  EXPECT_EQ(dice.cell_count(), 64);
  EXPECT_EQ(cell_at(dice, {-0.04, 0.01, -0.03}), 0);
  EXPECT_EQ(cell_at(dice, {0.04, 0.01, -0.03}), 3);
  EXPECT_EQ(cell_at(dice, {-0.04, 0.07, -0.03}), 12);
  EXPECT_EQ(cell_at(dice, {0.04, 0.07, 0.03}), 63);

  const KnifePlanes sticks = planes_of(parse_knife("sticks:30mm"), box);
  EXPECT_EQ(sticks.cell_count(), 5 * 4);
  for (const CuttingPlane& plane : sticks.planes) EXPECT_EQ(plane.normal.y, 0);
  EXPECT_THROW(planes_of(parse_knife("dice:0.001mm"), box), Error);
}

TEST(Knife, SidesNumberTheCells) {
  const KnifePlanes slices = planes_of(parse_knife("slices:4"), box);
  EXPECT_EQ(cell_at(slices, {0, 0.01, 0}), 0);
  EXPECT_EQ(cell_at(slices, {0, 0.07, 0}), 3);
  const KnifePlanes half = planes_of(parse_knife("half"), box);
  EXPECT_EQ(cell_at(half, {0, 0, -1}), 0);
  EXPECT_EQ(cell_at(half, {0, 0, 0}), 1);
}

}  // namespace
}  // namespace pomona
