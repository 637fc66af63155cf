// Leaves that wrap each other, and blades.
#include "generator/surface/sweep/sheet_shells.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/surface/bodies.h"
#include "generator/surface/crossings.h"
#include "generator/surface/sweep/sweep.h"
#include "tests/surface/sketches.h"

namespace pomona {
namespace {

using namespace sketches;

/// Half a circle, and one within it, from below the middle to the pole.
Curve dome(double radius) {
  Curve curve;
  for (int i = 0; i <= 40; ++i) {
    const double angle = -1.2 + (1.5707963267948966 + 1.2) * i / 40;
    curve.points.emplace_back(i == 40 ? 0 : radius * std::cos(angle), 0.05 + radius * std::sin(angle));
  }
  return curve;
}

SheetSketch leaves(int count) {
  SheetSketch sketch;
  sketch.name = "leaves";
  sketch.count = count;
  sketch.inner = dome(0.01);
  sketch.outer = dome(0.05);
  sketch.turn_jitter = 0.15;
  sketch.outline = Ramp<double>{{{0.0, 0.2}, {0.4, 0.8}, {1.2, 0.4}}};
  sketch.reach = Ramp<double>::constant(1.15);
  sketch.thickness = Ramp<double>{{{0.0, 0.002}, {1.2, 0.0008}}};
  sketch.rib = {0.1, Ramp<double>{{{0.0, 0.003}, {0.8, 0.0}}}};
  sketch.ruffle = {0.001, 4};
  sketch.front = {0, {Ramp<Color>::constant(Color(0.5f))}, true};
  sketch.back = {1, {Ramp<Color>::constant(Color(1.0f))}, false};
  return sketch;
}

Template head(const SheetSketch& sketch) {
  Template made = fruit({});
  made.sheets = {sketch};
  return made;
}

TEST(SheetShells, LeavesAreClosedBodiesThatDoNotCross) {
  const DiffusionSurfaces surfaces = sweep(head(leaves(16)), {.key = {3, 0}});
  EXPECT_TRUE(crossing_triangles(surfaces).empty());
  const Bodies bodies = find_bodies(surfaces);
  ASSERT_EQ(bodies.bodies.size(), 16u);
  for (const Bodies::Body& body : bodies.bodies) {
    EXPECT_TRUE(body.closed);
    EXPECT_GT(body.volume, 0);
  }
  EXPECT_TRUE(bodies.warnings.empty());
}

TEST(SheetShells, AllKeysHaveTheSameTriangles) {
  const DiffusionSurfaces one = sweep(head(leaves(9)), {.key = {1, 0}}), two = sweep(head(leaves(9)), {.key = {2, 0}});
  EXPECT_EQ(one.triangle, two.triangle);
  EXPECT_NE(one.position, two.position);
  EXPECT_EQ(one.position, sweep(head(leaves(9)), {.key = {1, 0}}).position);
}

TEST(SheetShells, TheLastLeafLiesNearTheOuterCurve) {
  const DiffusionSurfaces surfaces = sweep(head(leaves(20)), {.key = {1, 0}});
  double most = 0;
  for (const glm::vec3& p : surfaces.position)
    most = std::max(most, glm::distance(glm::dvec3(p), glm::dvec3(0, 0.05, 0)));
  EXPECT_GT(most, 0.047);
  EXPECT_LT(most, 0.056);
}

TEST(SheetShells, BladesStandSideBySide) {
  SheetSketch gills = leaves(60);
  gills.kind = SheetSketch::Kind::blades;
  gills.inner.points = {{0.009, 0.02}, {0.028, 0.02}};
  gills.outer.points = {{0.009, 0.027}, {0.028, 0.025}};
  gills.thickness = Ramp<double>::constant(0.0003);
  gills.lengths = {1.0, 0.4, 0.7, 0.4};
  gills.sway = 0.0003;
  gills.around = 5;
  gills.along = 12;
  const DiffusionSurfaces surfaces = sweep(head(gills), {.key = {3, 0}});
  EXPECT_TRUE(crossing_triangles(surfaces).empty());
  EXPECT_EQ(find_bodies(surfaces).bodies.size(), 60u);
  gills.thickness = Ramp<double>::constant(0.002);
  try {
    sweep(head(gills), {.key = {3, 0}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("too thick for their number"), std::string::npos);
  }
}

/// Sheets around the axis between two upright lines.
SheetSketch rolled(int count, double turns) {
  SheetSketch roll = leaves(count);
  roll.kind = SheetSketch::Kind::roll;
  roll.turns = turns;
  roll.inner.points = {{0.003, 0}, {0.003, 0.05}};
  roll.outer.points = {{0.03, 0}, {0.028, 0.04}, {0.026, 0.05}};
  roll.thickness = Ramp<double>::constant(0.002);
  roll.around = 40;
  roll.along = 8;
  return roll;
}

/// Layers between two level lines and a bulge.
SheetSketch stacked(int count) {
  SheetSketch stack = leaves(count);
  stack.kind = SheetSketch::Kind::stack;
  stack.inner.points = {{0, 0}, {0.04, 0}};
  stack.outer.points = {{0, 0.03}, {0.03, 0.03}, {0.04, 0.028}};
  stack.thickness = Ramp<double>::constant(0.003);
  stack.divergence = 0;
  stack.turn_jitter = 0;
  stack.ruffle = {};
  stack.around = 40;
  stack.along = 10;
  return stack;
}

void expect_refused(const SheetSketch& sketch, const std::string& words) {
  try {
    sweep(head(sketch), {.key = {3, 0}});
    ADD_FAILURE() << "not refused: " << words;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

double volume_of_bodies(const DiffusionSurfaces& surfaces) {
  double sum = 0;
  for (const Bodies::Body& body : find_bodies(surfaces).bodies) sum += body.volume;
  return sum;
}

TEST(SheetShells, ARollIsOneBodyForEachSheet) {
  for (const int count : {1, 3}) {
    SheetSketch roll = rolled(count, 9.0 / count);
    for (const double sway : {0.0, 0.004}) {
      roll.sway = sway;
      const DiffusionSurfaces surfaces = sweep(head(roll), {.key = {3, 0}});
      EXPECT_TRUE(crossing_triangles(surfaces).empty()) << count;
      const Bodies bodies = find_bodies(surfaces);
      EXPECT_EQ(bodies.bodies.size(), static_cast<std::size_t>(count));
      for (const Bodies::Body& body : bodies.bodies) EXPECT_TRUE(body.closed && body.volume > 0);
    }
  }
}

// As long as the spiral, as high as the lines, as thick as it says: but for its rims, and for chords.
TEST(SheetShells, ARollHasTheVolumeOfASheet) {
  SheetSketch roll = rolled(1, 9);
  roll.outer.points = {{0.03, 0}, {0.03, 0.05}};
  roll.around = 160;
  roll.along = 60;
  const double length = 9 * 2 * 3.14159265358979 * (0.003 + 0.03) / 2;
  const double volume = volume_of_bodies(sweep(head(roll), {.key = {3, 0}}));
  EXPECT_NEAR(volume, length * 0.05 * 0.002, 0.05 * volume);
}

TEST(SheetShells, ARollIsRefusedWhereItsTurnsWouldCross) {
  expect_refused(rolled(1, 14), "so many turns have no room");
  SheetSketch roll = rolled(1, 5);
  roll.outer.points = {{0.03, 0.05}, {0.03, 0}};
  expect_refused(roll, "cross, or run apart too steeply");
  roll = rolled(1, 5);
  roll.inner.points = {{0.0005, 0}, {0.0005, 0.05}};
  expect_refused(roll, "reaches the axis");
}

TEST(SheetShells, LayersOfAStackDoNotCrossWhereverTheyEnd) {
  SheetSketch stack = stacked(6);
  stack.outline_jitter = 0.08;
  stack.stray = 0.003;
  stack.turn_jitter = 0.5;
  stack.ruffle = {0.004, 5};
  stack.gap = 1e-4;
  stack.loop = loop([](double angle) { return 1 + 0.2 * std::cos(4 * angle); });
  const DiffusionSurfaces surfaces = sweep(head(stack), {.key = {3, 0}});
  EXPECT_TRUE(crossing_triangles(surfaces).empty());
  const Bodies bodies = find_bodies(surfaces);
  ASSERT_EQ(bodies.bodies.size(), 6u);
  for (const Bodies::Body& body : bodies.bodies) EXPECT_TRUE(body.closed && body.volume > 0);
  const DiffusionSurfaces other = sweep(head(stack), {.key = {4, 0}});
  EXPECT_EQ(surfaces.triangle, other.triangle);
  EXPECT_NE(surfaces.position, other.position);
}

TEST(SheetShells, AStackReachesFromOneCurveToTheOther) {
  SheetSketch stack = stacked(3);
  stack.outer.points = {{0, 0.03}, {0.04, 0.03}};
  stack.by_age = Ramp<double>{{{0.0, 1.0}, {1.0, 2.0}}};
  stack.around = 120;
  stack.along = 40;
  const DiffusionSurfaces surfaces = sweep(head(stack), {.key = {3, 0}});
  double low = 1, high = 0;
  for (const glm::vec3& p : surfaces.position) {
    low = std::min(low, static_cast<double>(p.y));
    high = std::max(high, static_cast<double>(p.y));
  }
  EXPECT_NEAR(low, 0, 1e-6);
  EXPECT_NEAR(high, 0.03, 1e-6);
  const double discs = 3.14159265358979 * 0.04 * 0.04 * 0.003 * (1 + 1.5 + 2);
  EXPECT_NEAR(volume_of_bodies(surfaces), discs, 0.05 * discs) << "but for round rims";
}

TEST(SheetShells, AStackWithoutRoomIsRefused) {
  expect_refused(stacked(11), "so many layers have no room");
  SheetSketch stack = stacked(6);
  stack.outer.points = {{0, 0.03}, {0.039, 0.03}, {0.04, 0.001}};
  expect_refused(stack, "so many layers have no room");
}

TEST(SheetShells, TooManyLeavesAreRefused) {
  SheetSketch sketch = leaves(60);
  sketch.thickness = Ramp<double>::constant(0.004);
  try {
    sweep(head(sketch), {.key = {1, 0}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("have no room"), std::string::npos);
  }
}

}  // namespace
}  // namespace pomona
