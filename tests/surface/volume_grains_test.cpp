// Grains inside a surface.
#include "generator/surface/grains/volume_grains.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/units.h"
#include "generator/mesh/moments.h"
#include "generator/surface/bodies.h"
#include "generator/surface/crossings.h"
#include "generator/surface/grains/grains.h"
#include "generator/surface/sweep/sweep.h"
#include "tests/surface/sketches.h"

namespace pomona {
namespace {

using namespace sketches;

constexpr double radius = 0.04;

GrainSketch crumbs(double share) {
  GrainSketch sketch;
  sketch.name = "crumbs";
  sketch.volume =
      GrainVolume{.from = 0.004, .to = 0.012, .exponent = 2.5, .share = share, .wall = 0.0005, .apart = 0.0002};
  sketch.form.length = 0.012 * 1.3;
  sketch.form.width = 0.012;
  sketch.form.thickness = 0.012 * 0.8;
  sketch.front = {0, {Ramp<Color>::constant(Color(0.9f, 0.8f, 0.5f))}, false};
  sketch.back = {1, {Ramp<Color>::constant(Color(1))}, false};
  return sketch;
}

/// A ball of 8 cm, its skin facing air, with grains inside.
Template filled(const GrainSketch& grains) {
  Template made = fruit({around_axis(meridian(radius), circle(1))});
  made.surfaces.front().front.hidden = true;
  made.grains = {grains};
  return made;
}

double volume_of(const DiffusionSurfaces& grains) {
  return std::fabs(moments_of(grains.position, grains.triangle, {0, 0, 0}).mass);
}

constexpr double ball = 4.0 / 3 * pi * radius * radius * radius;

TEST(VolumeGrains, FillTheirShareInsideTheWall) {
  for (const double share : {0.05, 0.2, 0.35}) {
    const Template made = filled(crumbs(share));
    const DiffusionSurfaces grains = scatter_grains(made, {3, 0});
    // Ellipsoids of 20 triangles and more fill two thirds of their own volume, and more.
    EXPECT_GT(volume_of(grains), 0.6 * share * ball);
    EXPECT_LT(volume_of(grains), 1.0 * share * ball);
    for (const glm::vec3& p : grains.position)
      ASSERT_LT(glm::distance(glm::dvec3(p), glm::dvec3(0, radius, 0)), radius - 0.0004);
  }
}

TEST(VolumeGrains, NoTwoCross) {
  const Template made = filled(crumbs(0.35));
  EXPECT_TRUE(crossing_triangles(scatter_grains(made, {5, 0})).empty());
}

TEST(VolumeGrains, AllVariantsHaveTheSameTrianglesAndEachKeyOtherPlaces) {
  const Template made = filled(crumbs(0.25));
  const DiffusionSurfaces one = scatter_grains(made, {1, 0}), two = scatter_grains(made, {2, 0});
  EXPECT_EQ(one.triangle, two.triangle);
  EXPECT_NE(one.position, two.position);
  EXPECT_EQ(one.position, scatter_grains(made, {1, 0}, {.threads = {3}}).position);
}

TEST(VolumeGrains, SizesFollowThePowerLaw) {
  const GrainVolume volume{.from = 0.001, .to = 0.01, .exponent = 3};
  // The share of grains that are larger than s: (s^-2 - to^-2) / (from^-2 - to^-2).
  constexpr std::size_t count = 1000;
  for (const std::size_t n : {10u, 100u, 500u, 990u}) {
    const double size = volume_size(volume, n, count);
    const double larger = (std::pow(size, -2) - 1e4) / (1e6 - 1e4);
    EXPECT_NEAR(larger, (static_cast<double>(n) + 0.5) / count, 1e-9);
  }
  EXPECT_GT(volume_size(volume, 0, count), volume_size(volume, 1, count));
}

TEST(VolumeGrains, BubblesAreCavitiesOfTheirBody) {
  GrainSketch bubbles = crumbs(0.1);
  bubbles.back.hidden = true;
  const Template made = filled(bubbles);
  const DiffusionSurfaces swept = sweep(made);
  const DiffusionSurfaces grains = scatter_grains(made, {7, 0});
  const Bodies bodies = find_bodies(joined(swept, grains));
  ASSERT_EQ(bodies.bodies.size(), 1u);
  EXPECT_TRUE(bodies.bodies.front().closed);
  EXPECT_GT(bodies.bodies.front().shells, 10);
  EXPECT_NEAR(bodies.bodies.front().volume,
              std::fabs(moments_of(swept.position, swept.triangle, {0, 0, 0}).mass) - volume_of(grains), 1e-9);
}

TEST(VolumeGrains, TheLargestStayAwayFromTheSkin) {
  GrainSketch sketch = crumbs(0.08);
  sketch.volume->near_skin = Ramp<double>{{{0.0, 0.4}, {0.02, 1.0}}};
  const Template made = filled(sketch);
  const std::vector<Dart> darts =
      volume_darts(made, sketch, grain_draws({1, 0}, sketch.name), {1, 0}, SweepOptions{}, {});
  for (const Dart& dart : darts) {
    const double depth = radius - glm::distance(dart.center, glm::dvec3(0, radius, 0));
    EXPECT_LE(dart.spacing, sketch.volume->to * sketch.volume->near_skin(depth) + 3e-4);
  }
}

TEST(VolumeGrains, HeadingsFollowABentAxis) {
  GrainSketch sketch = crumbs(0.05);
  sketch.volume->heading = GrainVolume::Heading::along;
  Template made = filled(sketch);
  made.bend.angle = radians(40);
  made.bend.direction = 0;
  const std::vector<Dart> darts =
      volume_darts(made, sketch, grain_draws({1, 0}, sketch.name), {1, 0}, SweepOptions{}, {});
  // The bend lies in the plane of x and y; near its ends the axis leans by up to half the angle, to either side.
  double most = 0;
  for (const Dart& dart : darts) {
    const glm::dvec3 along = glm::normalize(dart.pose.length);
    EXPECT_NEAR(along.z, 0, 1e-6);
    EXPECT_LT(std::acos(std::fabs(along.y)), radians(20.1));
    most = std::max(most, std::acos(std::fabs(along.y)));
  }
  EXPECT_GT(most, radians(8));
}

TEST(VolumeGrains, TooManyAreRefusedBeforeTheyAreMade) {
  GrainSketch sketch = crumbs(0.4);
  sketch.volume->from = 0.0003;
  sketch.volume->exponent = 4;
  try {
    scatter_grains(filled(sketch), {1, 0});
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("20 000 grains"), std::string::npos);
  }
}

}  // namespace
}  // namespace pomona
