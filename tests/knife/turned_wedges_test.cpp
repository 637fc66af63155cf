// Wedges of a variant begin where all of their half-planes keep clear of the walls of its chambers.
#include "generator/knife/turned_wedges.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "generator/base/units.h"
#include "generator/knife/parse_knife.h"

namespace pomona {
namespace {

/// Even folds, the first at this angle in degrees; a loop in each leaves so many degrees free at either fold line.
Template with_folds(int count, double first, double free = 0) {
  Template fruit;
  fruit.parts = {"flesh", "pulp"};
  FoldSymmetry symmetry;
  SurfaceSketch chamber;
  chamber.type = SurfaceType::in_fold;
  chamber.front.part = 0;
  chamber.back.part = 1;
  for (int k = 0; k < count; ++k) {
    const double from = radians(first) + 2 * pi * k / count, to = from + 2 * pi / count;
    symmetry.fold_angles.push_back(from);
    Curve loop;
    loop.closed = true;
    for (const double angle : {from + radians(free), to - radians(free)})
      for (const double radius : {0.01, 0.03})
        loop.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    chamber.horizontal.push_back(loop);
  }
  fruit.symmetry = symmetry;
  if (free > 0) fruit.surfaces.push_back(chamber);
  return fruit;
}

/// Degrees between the nearest half-plane and fold line.
double margin(double start, int wedges, int folds, double first) {
  double least = 360;
  for (int i = 0; i < wedges; ++i) {
    for (int k = 0; k < folds; ++k) {
      const double turn = start / (2 * pi) + 1.0 * i / wedges - first / 360 - 1.0 * k / folds;
      least = std::min(least, 360 * std::fabs(turn - std::round(turn)));
    }
  }
  return least;
}

TEST(TurnedWedges, KeepClearOfWalls) {
  for (const double free : {0.0, 3.0}) {
    for (const int folds : {5, 8, 9, 10}) {
      for (const int wedges : {3, 4, 6, 8}) {
        const double start = wedge_start(with_folds(folds, 0, free), wedges);
        // Half-planes and walls together repeat in this angle, so nothing can lie farther off than its half.
        const double repeat = 360.0 / std::lcm(folds, wedges);
        EXPECT_LE(std::fabs(start), pi / wedges + 1e-12);
        EXPECT_GT(margin(start, wedges, folds, 0), 0.45 * std::min(repeat, 180.0 / folds)) << folds << " " << wedges;
      }
    }
  }
}

TEST(TurnedWedges, StayWhereNoWallIsNear) {
  EXPECT_EQ(wedge_start(with_folds(6, 30, 3), 6), 0);
  EXPECT_EQ(wedge_start(with_folds(6, 5.5, 3), 6), 0) << "2.5 degrees from the loop";
  EXPECT_NE(wedge_start(with_folds(6, 4.5, 3), 6), 0) << "1.5 degrees from it";
  EXPECT_EQ(wedge_start(Template{}, 6), 0) << "no folds";
}

TEST(TurnedWedges, AreTheOnlyKnivesThatTurn) {
  const std::vector<Knife> knives{parse_knife("half"), parse_knife("wedges:6"), parse_knife("ball:10mm")};
  const std::vector<Knife> turned = turned_wedges(knives, with_folds(6, 0, 3));
  ASSERT_EQ(turned.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(turned[i].text, knives[i].text);
  EXPECT_NE(std::get<WedgeKnife>(std::get<PlaneCut>(turned[1].cut)).start, 0);
}

}  // namespace
}  // namespace pomona
