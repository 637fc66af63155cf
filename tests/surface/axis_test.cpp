// Axes that are drawn, sections that turn about them, loops that change along them, surfaces beside them.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/surface/bodies.h"
#include "generator/surface/sweep/body_map.h"
#include "generator/surface/sweep/section_loop.h"
#include "generator/surface/sweep/surface_grids.h"
#include "generator/surface/sweep/sweep.h"
#include "generator/template/bend_strain.h"
#include "tests/shapes/shapes.h"
#include "tests/surface/sketches.h"

namespace pomona {
namespace {

using namespace sketches;
using shapes::signed_volume;

/// A rod of this length and radius with rounded ends, closed on the axis.
Curve rod(double length, double radius) {
  Curve curve;
  for (int i = 0; i <= 40; ++i)
    curve.points.emplace_back(radius * std::sin(pi * i / 80), radius * (1 - std::cos(pi * i / 80)));
  for (int i = 0; i <= 40; ++i)
    curve.points.emplace_back(radius * std::cos(pi * i / 80), length - radius + radius * std::sin(pi * i / 80));
  curve.points.front().x = curve.points.back().x = 0;
  return curve;
}

Template rod_fruit() { return fruit({around_axis(rod(0.2, 0.02), circle(0.02))}); }

std::vector<double> arc(double from, double to, int nodes = 65) {
  std::vector<double> leans;
  for (int i = 0; i < nodes; ++i) leans.push_back(from + (to - from) * i / (nodes - 1));
  return leans;
}

double azimuth_of(const glm::dvec3& p) { return reproducible::atan2(-p.z, p.x); }

TEST(Axis, AnUprightLineChangesNothing) {
  Template drawn = rod_fruit();
  drawn.bend.line = arc(0, 0);
  const BodyMap map(drawn);
  for (const glm::dvec3& p : {glm::dvec3(0.01, 0.03, 0.005), glm::dvec3(-0.02, 0.2, 0), glm::dvec3(0)})
    EXPECT_NEAR(glm::distance(map(p), p), 0, 1e-12);
}

TEST(Axis, ALyingLineLaysTheFruitDown) {
  Template drawn = rod_fruit();
  drawn.bend.line = arc(pi / 2, pi / 2);
  const BodyMap map(drawn);
  const glm::dvec3 along = map({0, 0.2, 0}) - map({0, 0, 0});
  EXPECT_NEAR(glm::distance(along, {0.2, 0, 0}), 0, 1e-12);
  EXPECT_NEAR(map({0, 0.1, 0}).x, 0, 1e-12);
  EXPECT_NEAR(map({0, 0.1, 0.02}).z, 0.02, 1e-12);
  EXPECT_EQ(bend_strain(drawn).pressing, 0);
}

TEST(Axis, AnArcKeepsLengthSectionsAndVolume) {
  Template drawn = rod_fruit();
  const double straight = signed_volume(sweep(drawn));
  drawn.bend.line = arc(-1, 1);
  const BodyMap map(drawn);
  const double radius = 0.1;  // 0.2 m turn by 2 radians
  const glm::dvec3 middle = map({0, 0.1, 0}), center = middle + glm::dvec3(radius, 0, 0);
  for (double y = 0; y <= 0.2; y += 0.01) {
    EXPECT_NEAR(glm::distance(map({0, y, 0}), center), radius, 1e-9);
    EXPECT_NEAR(glm::distance(map({0.015, y, 0}), center), radius - 0.015, 1e-9);
  }
  EXPECT_NEAR(signed_volume(sweep(drawn)), straight, 3e-3 * straight);
  EXPECT_NEAR(bend_strain(drawn).pressing, 0.02 / radius, 1e-3);
  EXPECT_NEAR(bend_strain(drawn).lean, 1, 1e-9);
}

TEST(Axis, ABendComesOnTopOfTheLine) {
  AxisBend both{.angle = 0.4, .swing = 0.2}, bend = both;
  both.line = arc(0.3, 0.9);
  for (const double place : {-1.0, -0.3, 0.2, 1.0}) {
    EXPECT_NEAR(both.lean(place), bend.lean(place) + 0.6 + 0.3 * place, 1e-12);
    EXPECT_NEAR(both.turning(place), bend.turning(place) + 0.3, 1e-12);
  }
  EXPECT_NEAR(both.largest_turning(-1, 1), 0.2 + 0.2 + 0.3, 1e-12);
  EXPECT_FALSE(both.as_line().is_straight());
  EXPECT_EQ(both.as_line().lean(0), both.line[32]);
  EXPECT_TRUE(bend.as_line().is_straight());
}

TEST(Axis, TwistTurnsSectionsAndKeepsVolume) {
  // A ridge at azimuth 0, turned by a quarter against the clock on the way to the top.
  const Curve ridged = loop([](double a) { return 0.02 * (1 + 0.2 * std::exp(-a * a / 0.05)); });
  Template drawn = fruit({around_axis(rod(0.2, 0.02), ridged)});
  const double straight = signed_volume(sweep(drawn));
  drawn.bend.twist = {{{0, 0}, {1, pi / 2}}};
  EXPECT_FALSE(drawn.bend.is_straight());
  const BodyMap map(drawn);
  EXPECT_NEAR(azimuth_of(map({0.02, 0, 0})), 0, 1e-12);
  EXPECT_NEAR(azimuth_of(map({0.02, 0.1, 0})), pi / 4, 1e-12);
  EXPECT_NEAR(azimuth_of(map({0.02, 0.2, 0})), pi / 2, 1e-12);
  EXPECT_NEAR(signed_volume(sweep(drawn)), straight, 5e-3 * straight);
  const Bodies found = find_bodies(sweep(drawn));
  ASSERT_EQ(found.bodies.size(), 1u);
  EXPECT_TRUE(found.bodies[0].closed);
}

Curve ridges(int count) {
  return loop([=](double a) { return 0.02 * (1 + 0.15 * std::cos(count * a)); });
}

TEST(LoopStops, AtAStopIsItsLoopAndBetweenIsNeither) {
  const SectionStops stops{{0.2, 0.8}, {sampled_loop(circle(1), 60, 1), sampled_loop(ridges(5), 60, 0.02)}};
  for (const double share : {0.0, 0.2}) EXPECT_EQ(loop_at(stops, share).radius, stops.loop[0].radius);
  for (const double share : {0.8, 1.0}) EXPECT_EQ(loop_at(stops, share).radius, stops.loop[1].radius);
  const SectionLoop middle = loop_at(stops, 0.5);
  double turned = 0;
  for (std::size_t i = 0; i < middle.radius.size(); ++i) {
    EXPECT_NEAR(middle.radius[i], 0.5 * (stops.loop[0].radius[i] + stops.loop[1].radius[i]), 1e-12);
    const glm::dvec2 &a = middle.direction[i], &b = middle.direction[(i + 1) % middle.direction.size()];
    const double step = reproducible::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b));
    EXPECT_GT(step, 0);
    turned += step;
  }
  EXPECT_NEAR(turned, 2 * pi, 1e-9);
}

TEST(LoopStops, ASurfaceIsRoundWhereItsStopIs) {
  SurfaceSketch skin = around_axis(rod(0.2, 0.02), circle(0.02));
  skin.horizontal.push_back(ridges(5));
  skin.stops = {0.3, 0.7};
  const Template drawn = fruit({skin});
  const SweptGrid grid = swept_grids(drawn, skin, {}).front();
  for (std::size_t v = 0; v < grid.position.size(); ++v) {
    const double radius = glm::length(glm::dvec2(grid.position[v].x, grid.position[v].z));
    if (grid.is_pole[v] != 0 || grid.position[v].y < 0.025 || grid.position[v].y > 0.175) continue;
    if (grid.along[v] < 0.3) {
      EXPECT_NEAR(radius, 0.02, 1e-6);
    } else if (grid.along[v] > 0.7) {
      EXPECT_NEAR(radius, 0.02 * (1 + 0.15 * std::cos(5 * azimuth_of(grid.position[v]))), 2e-4);
    }
  }
  const Bodies found = find_bodies(sweep(drawn));
  ASSERT_EQ(found.bodies.size(), 1u);
  EXPECT_TRUE(found.bodies[0].closed);
}

TEST(LoopStops, NeedALoopEach) {
  SurfaceSketch skin = around_axis(rod(0.2, 0.02), circle(0.02));
  skin.stops = {0.3, 0.7};
  EXPECT_THROW(sweep(fruit({skin})), Error);
}

TEST(Off, SectionsLieBesideTheAxis) {
  SurfaceSketch stone = around_axis(rod(0.1, 0.01), circle(0.01));
  const Template before = fruit({stone});
  stone.off = {{{{0, 0}, {0.5, 0.004}}}, Ramp<double>::constant(-0.001)};
  const Template after = fruit({stone});
  const SweptGrid straight = swept_grids(before, before.surfaces[0], {}).front();
  const SweptGrid aside = swept_grids(after, after.surfaces[0], {}).front();
  for (std::size_t v = 0; v < straight.position.size(); ++v) {
    const double x = 0.008 * std::min(straight.along[v], 0.5);
    EXPECT_NEAR(glm::distance(aside.position[v], straight.position[v] + glm::dvec3(x, 0, -0.001)), 0, 1e-9);
  }
  EXPECT_NEAR(signed_volume(sweep(after)), signed_volume(sweep(before)), 1e-3 * signed_volume(sweep(before)));
}

}  // namespace
}  // namespace pomona
