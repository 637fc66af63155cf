// Leaves that wrap each other, and blades.
#include "generator/surface/sweep/sheet_shells.h"

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
