#include "generator/surface/sweep/sweep.h"

#include <cmath>
#include <set>
#include <utility>

#include <gmock/gmock.h>

#include "generator/base/error.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/surface/bodies.h"
#include "tests/shapes/shapes.h"
#include "tests/surface/sketches.h"

namespace pomona {
namespace {

using namespace sketches;
using shapes::signed_volume;

int euler_characteristic(const DiffusionSurfaces& surfaces) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const glm::uvec3& t : surfaces.triangle) {
    for (int k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
  }
  return static_cast<int>(surfaces.vertex_count()) - static_cast<int>(edges.size()) +
         static_cast<int>(surfaces.triangle_count());
}

double angle(const glm::vec3& p) { return reproducible::atan2(-p.z, p.x); }

void expect_one_closed_body(const DiffusionSurfaces& surfaces, double volume, double tolerance) {
  const Bodies found = find_bodies(surfaces);
  ASSERT_EQ(found.bodies.size(), 1u);
  EXPECT_TRUE(found.bodies[0].closed);
  EXPECT_NEAR(found.bodies[0].volume, volume, tolerance * volume);
  EXPECT_GT(signed_volume(surfaces), 0);
}

TEST(Sweep, ASphereHasItsVolumeAndTwoPoles) {
  const DiffusionSurfaces ball = sweep(fruit({around_axis(meridian(0.04), circle(0.1))}));
  EXPECT_EQ(ball.vertex_count(), 96u * 46 + 2);
  EXPECT_EQ(ball.triangle_count(), 2u * 96 * 46);
  EXPECT_EQ(euler_characteristic(ball), 2);
  expect_one_closed_body(ball, 4 * pi / 3 * 0.04 * 0.04 * 0.04, 0.003);
  EXPECT_EQ(ball.position.front(), glm::vec3(0));
  EXPECT_EQ(ball.position.back().x, 0);
}

TEST(Sweep, KnowsThePartsByName) {
  Template made = fruit({around_axis(meridian(0.04), circle(0.1))});
  made.parts = {"peel", "pulp", "pip"};
  EXPECT_EQ(sweep(made).part_names, made.parts);
}

TEST(Sweep, AClosedProfileMakesATorus) {
  const DiffusionSurfaces ring = sweep(fruit({around_axis(circle_at({0.05, 0.02}, 0.02), circle(1))}));
  EXPECT_EQ(euler_characteristic(ring), 0);
  expect_one_closed_body(ring, 2 * pi * pi * 0.05 * 0.02 * 0.02, 0.01);
}

TEST(Sweep, FrontIsOutsideWhicheverWayTheProfileWasDrawn) {
  SurfaceSketch up = around_axis(meridian(0.04), circle(0.1));
  SurfaceSketch down = up;
  std::reverse(down.vertical.points.begin(), down.vertical.points.end());
  SurfaceSketch clockwise = up;
  std::reverse(clockwise.horizontal[0].points.begin(), clockwise.horizontal[0].points.end());
  for (const SurfaceSketch& sketch : {up, down, clockwise}) {
    expect_one_closed_body(sweep(fruit({sketch})), 4 * pi / 3 * 0.04 * 0.04 * 0.04, 0.003);
  }
}

TEST(Sweep, ABowlGoesUpOverTheRimAndDownInside) {
  // A cup with 2 cm walls: 10 cm wide, 10 cm high, drawn with sharp corners.
  const Curve profile{{{0, 0}, {0.05, 0}, {0.05, 0.1}, {0.03, 0.1}, {0.03, 0.02}, {0, 0.02}}, false};
  SurfaceSketch bowl = around_axis(profile, circle(0.05));
  bowl.around = 192;
  const DiffusionSurfaces swept = sweep(fruit({bowl}));
  expect_one_closed_body(swept, pi * (0.05 * 0.05 * 0.1 - 0.03 * 0.03 * 0.08), 0.002);
  // Corners are kept: without them the volume would be less.
  const Box<double> bounds = bounds_of(swept);
  EXPECT_NEAR(bounds.size().y, 0.1, 1e-8);
}

TEST(Sweep, OpenEndsAreOpenRims) {
  const DiffusionSurfaces tube = sweep(fruit({around_axis({{{0.05, 0}, {0.05, 0.1}}, false}, circle(1))}));
  EXPECT_EQ(euler_characteristic(tube), 0);
  EXPECT_FALSE(find_bodies(tube).bodies[0].closed);
  const std::vector<glm::vec3> normals = vertex_normals(tube);
  EXPECT_GT(normals[0].x, 0.9f);
}

TEST(Sweep, AnglesRunFromXTowardsMinusZ) {
  // A loop with a bump at 90 degrees: it must show at -z.
  const Curve bumped = loop([](double a) { return 1 + (std::fabs(a - pi / 2) < 0.2 ? 0.3 : 0.0); });
  const Box<double> bounds = bounds_of(sweep(fruit({around_axis(meridian(0.04), bumped)})));
  EXPECT_GT(-bounds.low.z, 1.2 * bounds.high.z);
  const DiffusionSurfaces ball = sweep(fruit({around_axis(meridian(0.04), bumped)}));
  EXPECT_EQ(ball.position[1].z, 0);
  EXPECT_GT(ball.position[1].x, 0);
  EXPECT_LT(ball.position[3].z, 0);
}

TEST(Sweep, TheReferenceAzimuthCarriesTheProfile) {
  const Curve egg = loop([](double a) { return 1 + 0.3 * reproducible::cos(a); });
  SurfaceSketch sketch = around_axis(meridian(0.04), egg);
  sketch.reference_azimuth = pi;
  EXPECT_NEAR(bounds_of(sweep(fruit({sketch}))).low.x, -0.04, 1e-4);
  sketch.reference_azimuth.reset();
  EXPECT_NEAR(bounds_of(sweep(fruit({sketch}))).high.x, 0.04 * 1.3, 2e-4);
}

TEST(Sweep, AVariantKeepsTheScaleOfTheDrawing) {
  // The drawn loop has radius 1; the variant's is larger by a fifth.
  SurfaceSketch sketch = around_axis(meridian(0.04), circle(1.2));
  sketch.reference = ReferenceRadii{0, 1};
  EXPECT_NEAR(bounds_of(sweep(fruit({sketch}))).high.x, 0.048, 1e-4);

  // A chamber twice as deep, outwards: the drawn one reaches from 2 to 4 cm.
  SurfaceSketch chamber = in_fold(circle_at({0.03, 0.04}, 0.01), {circle_at({0.04, 0}, 0.02), {}});
  chamber.reference = ReferenceRadii{0.02, 0.04};
  Template made = fruit({chamber}, 2);
  std::get<FoldSymmetry>(made.symmetry).fold_angles = {-pi / 2, pi / 2};
  EXPECT_NEAR(bounds_of(sweep(made)).high.x, 0.06, 3e-4);
}

TEST(Sweep, RoundnessMakesCircles) {
  SurfaceSketch sketch = around_axis(meridian(0.04), loop([](double a) { return 1 + 0.3 * reproducible::cos(5 * a); }));
  sketch.roundness = Ramp<double>::constant(1);
  const DiffusionSurfaces ball = sweep(fruit({sketch}));
  expect_one_closed_body(ball, 4 * pi / 3 * 0.04 * 0.04 * 0.04, 0.01);
}

TEST(Sweep, ConnectivityDoesNotDependOnTheCurves) {
  const Curve wavy = loop([](double a) { return 0.03 + 0.01 * reproducible::cos(5 * a); });
  const DiffusionSurfaces a = sweep(fruit({around_axis(meridian(0.04), wavy)}, 5));
  const DiffusionSurfaces b = sweep(fruit({around_axis(meridian(0.02), circle(1))}, 5));
  EXPECT_EQ(a.triangle, b.triangle);
  EXPECT_EQ(a.front_color, b.front_color);
}

TEST(Sweep, FoldLinesCarryVertices) {
  const Curve wavy = loop([](double a) { return 0.03 + 0.01 * reproducible::cos(5 * a + 1); });
  Template made = fruit({around_axis(meridian(0.04), wavy)}, 5);
  std::get<FoldSymmetry>(made.symmetry).fold_angles = {0.3, 1.4, 2.9, 4.0, 5.2};
  const DiffusionSurfaces swept = sweep(made);
  const std::size_t per_fold = 19;  // 96 rounded to a multiple of five
  for (std::size_t k = 0; k < 5; ++k) {
    double difference =
        angle(swept.position[1 + 95 * 10 + k * per_fold]) - std::get<FoldSymmetry>(made.symmetry).fold_angles[k];
    difference -= 2 * pi * std::round(difference / (2 * pi));
    EXPECT_NEAR(difference, 0, 1e-6);
  }
}

TEST(Sweep, OneFoldIsAFoldToo) {
  expect_one_closed_body(sweep(fruit({around_axis(meridian(0.04), circle(1))}, 1)), 4 * pi / 3 * 6.4e-5, 0.003);
}

TEST(Sweep, ColoursAreAlongTimesAroundAndRepeatInEveryFold) {
  SurfaceSketch sketch = around_axis(meridian(0.04), circle(1));
  sketch.front.color.along = {{{0, Color(1, 0, 0)}, {1, Color(0, 1, 0)}}};
  sketch.front.color.around = {{{0, Color(1)}, {0.5, Color(0.5f)}, {1, Color(1)}}};
  sketch.blur.along = {{{0, 0.001}, {1, 0.003}}};
  const DiffusionSurfaces swept = sweep(fruit({sketch}, 4));
  EXPECT_NEAR(swept.front_color.front().r, 0.75f, 0.01f);
  const std::size_t ring = 1 + 96 * 10;
  EXPECT_EQ(swept.front_color[ring], swept.front_color[ring + 24]);
  EXPECT_NEAR(swept.front_color[ring].r + swept.front_color[ring].g, 1, 1e-5);
  EXPECT_NEAR(swept.front_color[ring + 12].r + swept.front_color[ring + 12].g, 0.5, 1e-5);
  EXPECT_FLOAT_EQ(swept.blur.back(), 0.003f);
}

TEST(Sweep, LoopsInFoldsBecomeClosedChambersThatStayInside) {
  std::vector<Curve> loops;
  for (int k = 0; k < 3; ++k) {
    const double middle = 2 * pi * (k + 0.5) / 3;
    loops.push_back(circle_at(0.03 * glm::dvec2(reproducible::cos(middle), reproducible::sin(middle)), 0.012));
  }
  loops[1].points.clear();
  SurfaceSketch chamber = in_fold(circle_at({0.03, 0.04}, 0.012), loops);
  chamber.front.hidden = true;
  const DiffusionSurfaces swept = sweep(fruit({chamber}, 3));
  const Bodies found = find_bodies(swept);
  ASSERT_EQ(found.bodies.size(), 2u);
  EXPECT_EQ(euler_characteristic(swept), 4);
  for (const Bodies::Body& body : found.bodies) {
    EXPECT_TRUE(body.closed);
    EXPECT_GT(body.volume, 0.9 * 4 * pi / 3 * 0.012 * 0.012 * 0.012);
    EXPECT_LT(body.volume, 2 * pi * 0.012 * 0.012 * 0.012);
  }
  for (std::size_t v = 0; v < swept.vertex_count(); ++v) {
    double a = angle(swept.position[v]);
    if (a < 0) a += 2 * pi;
    EXPECT_TRUE((a > 0 && a < 2 * pi / 3) || (a > 4 * pi / 3 && a < 2 * pi));
  }
}

TEST(Sweep, AFlatBottomedChamberStartsInTheMiddleOfItsBottom) {
  const Curve square{{{0.02, 0.01}, {0.04, 0.01}, {0.04, 0.05}, {0.02, 0.05}}, true};
  const DiffusionSurfaces swept = sweep(fruit({in_fold(square, {circle_at({-0.03, 0}, 0.01)})}, 1));
  EXPECT_NEAR(swept.position[0].x, -0.03, 1e-7);
  EXPECT_GT(signed_volume(swept), 0);
}

TEST(Sweep, DetailMultipliesTheCounts) {
  const Template made = fruit({around_axis(meridian(0.04), circle(1))});
  EXPECT_EQ(sweep(made, {.detail = 0.5}).vertex_count(), 48u * 22 + 2);
  EXPECT_EQ(sweep(made, {.detail = 0.01}).vertex_count(), 3u * 1 + 2);
}

std::string message_of(const Template& made) {
  try {
    sweep(made);
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_data);
    return error.what();
  }
  return "no error";
}

TEST(Sweep, WhatCannotBeSweptIsNamed) {
  using testing::HasSubstr;
  EXPECT_THAT(message_of(fruit({around_axis(meridian(0.04), circle_at({1, 0}, 0.5))})),
              HasSubstr("surface \"skin\": the horizontal curve does not surround the axis"));
  EXPECT_THAT(message_of(fruit({around_axis({{{0, 0}, {0.1, 0.1}, {-0.1, 0.2}, {0, 0.3}}, false}, circle(1))})),
              HasSubstr("crosses the axis"));
  EXPECT_THAT(
      message_of(fruit({around_axis({{{0, 0}, {0.1, 0.1}, {0, 0.2}, {0.1, 0.3}, {0, 0.4}}, false}, circle(1))})),
      HasSubstr("touches the axis"));
  EXPECT_THAT(message_of(fruit({around_axis({{{0, 0}, {0, 0}}, false}, circle(1))})), HasSubstr("no length"));
  // An S-shaped wall that crosses the fold line at 90 degrees three times.
  const Curve hooked{{{1, -1}, {1, 1.5}, {-0.5, 1.5}, {-0.5, 1.2}, {0.5, 1.2}, {0.5, 0.8}, {-1, 0.8}, {-1, -1}}, true};
  EXPECT_THAT(message_of(fruit({around_axis(meridian(0.04), hooked)}, 4)), HasSubstr("crosses fold line 1 3 times"));
  EXPECT_THAT(
      message_of(fruit({in_fold(circle_at({1, 1}, 0.1), {circle_at({1, 0}, 0.1), circle_at({-1, 1}, 0.1)})}, 2)),
      HasSubstr("fold 0 leaves its fold"));
  EXPECT_THAT(message_of(fruit({in_fold(circle_at({1, 1}, 0.1), {circle_at({1, 0}, 0.1)})})),
              HasSubstr("one horizontal"));
}

}  // namespace
}  // namespace pomona
