#include "generator/surface/grains/grains.h"

#include <cmath>
#include <fstream>

#include <gmock/gmock.h>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/units.h"
#include "generator/surface/bodies.h"
#include "tests/base/temporary_folder.h"
#include "tests/shapes/shapes.h"
#include "tests/surface/sketches.h"

namespace pomona {
namespace {

using namespace sketches;

GrainSketch seeds(double poisson_radius) {
  GrainSketch sketch;
  sketch.name = "seeds";
  sketch.spacing.poisson_radius = poisson_radius;
  sketch.form.length = 0.004;
  sketch.form.width = 0.003;
  sketch.form.thickness = 0.002;
  sketch.front = {0, {Ramp<Color>::constant(Color(0.9f, 0.8f, 0.5f))}, true};
  sketch.back = {1, {Ramp<Color>::constant(Color(1))}, false};
  return sketch;
}

/// A ball of 8 cm with grains on it.
Template seeded(const GrainSketch& grains) {
  Template made = fruit({around_axis(meridian(0.04), circle(1))});
  made.grains = {grains};
  return made;
}

constexpr std::size_t vertices_per_grain = 2 + 8 * 4;

/// The middle of each grain: half-way between its two poles.
std::vector<glm::dvec3> centers(const DiffusionSurfaces& grains, std::size_t of_each = vertices_per_grain) {
  std::vector<glm::dvec3> found;
  for (std::size_t v = 0; v < grains.vertex_count(); v += of_each) {
    found.push_back(0.5 * (glm::dvec3(grains.position[v]) + glm::dvec3(grains.position[v + of_each - 1])));
  }
  return found;
}

const glm::dvec3 middle(0, 0.04, 0);

TEST(Grains, OfMoreDetailLieWhereTheyLayAndAreRounder) {
  const Template ball = seeded(seeds(0.006));
  const DiffusionSurfaces usual = scatter_grains(ball, {1, 0}), fine = scatter_grains(ball, {1, 0}, {.detail = 3});
  const std::vector<glm::dvec3> at = centers(usual);
  ASSERT_GT(at.size(), 100u);
  EXPECT_EQ(centers(fine, 2 + 24 * 16), at);
  const double round = 4.0 / 3 * pi * 0.002 * 0.0015 * 0.001 * static_cast<double>(at.size());
  EXPECT_LT(round - shapes::signed_volume(fine), (round - shapes::signed_volume(usual)) / 8);
}

TEST(Grains, OfMoreDetailThanMemoryHoldsAreRefused) {
  GrainSketch sketch = seeds(0.003);
  sketch.form.around = sketch.form.along = 60;
  EXPECT_THROW(scatter_grains(seeded(sketch), {1, 0}, {.detail = 4}), Error);
}

TEST(Grains, NoTwoAreNearerThanThePoissonRadiusAndFewMoreWouldFit) {
  for (const double sink : {0.0, 0.005, -0.005}) {
    GrainSketch sketch = seeds(0.004);
    sketch.stance.sink = sink;
    const std::vector<glm::dvec3> at = centers(scatter_grains(seeded(sketch), {1, 0}));
    for (std::size_t i = 0; i < at.size(); ++i) {
      EXPECT_NEAR(glm::distance(at[i], middle), 0.04 - sink, 2e-4);
      for (std::size_t j = 0; j < i; ++j) ASSERT_GE(glm::distance(at[i], at[j]), 0.004 - 1e-8);
    }
    const double area = 4 * pi * (0.04 - sink) * (0.04 - sink);
    EXPECT_NEAR(static_cast<double>(at.size()), 0.70 * area / (0.004 * 0.004), 0.05 * 0.70 * area / (0.004 * 0.004));
  }
}

TEST(Grains, KnowThePartsByName) {
  Template made = seeded(seeds(0.008));
  made.parts = {"peel", "pulp", "pip"};
  EXPECT_EQ(scatter_grains(made, {1, 0}).part_names, made.parts);
}

TEST(Grains, TheSameKeyScattersTheSameGrains) {
  const Template fruit = seeded(seeds(0.006));
  const DiffusionSurfaces first = scatter_grains(fruit, {7, 3});
  EXPECT_EQ(first.position, scatter_grains(fruit, {7, 3}).position);
  EXPECT_NE(first.position, scatter_grains(fruit, {7, 4}).position);
  EXPECT_NE(first.position, scatter_grains(fruit, {0, 0}).position);
}

TEST(Grains, AreTheSameForAnyNumberOfThreads) {
  // Solid grains, and grains that keep apart from others, over several rounds.
  GrainSketch large = seeds(0.006), small = seeds(0.002);
  small.name = "small";
  small.spacing.solid = true;
  small.spacing.apart_from = {0};
  Template fruit = seeded(large);
  fruit.grains.push_back(small);
  const DiffusionSurfaces one = scatter_grains(fruit, {5, 0}, {.threads = {1}});
  EXPECT_GT(one.vertex_count(), 900 * vertices_per_grain);
  for (const int threads : {2, 7}) {
    EXPECT_EQ(one.position, scatter_grains(fruit, {5, 0}, {.threads = {threads}}).position) << threads;
  }
}

TEST(Grains, EachIsAClosedBodyFrontOutside) {
  for (const double pointedness : {0.0, 1.0}) {
    GrainSketch sketch = seeds(0.012);
    sketch.form.pointedness = pointedness;
    sketch.stance.angle_jitter = 1;
    sketch.stance.tilt = 0.5;
    sketch.form.around = 32;
    sketch.form.along = 32;
    const DiffusionSurfaces grains = scatter_grains(seeded(sketch), {});
    const Bodies found = find_bodies(grains);
    ASSERT_GT(found.bodies.size(), 50u);
    for (const Bodies::Body& body : found.bodies) {
      EXPECT_TRUE(body.closed);
      const double ellipsoid = pi / 6 * 0.004 * 0.003 * 0.002;
      if (pointedness == 0) {
        EXPECT_NEAR(body.volume, ellipsoid, 0.03 * ellipsoid);
      } else {
        EXPECT_THAT(body.volume, testing::AllOf(testing::Gt(0.5 * ellipsoid), testing::Lt(ellipsoid)));
      }
    }
  }
}

TEST(Grains, TipsRunUpTheCurveAndLieFlat) {
  GrainSketch sketch = seeds(0.008);
  sketch.ground.along_from = 0.3;
  sketch.ground.along_to = 0.7;
  const DiffusionSurfaces grains = scatter_grains(seeded(sketch), {2, 0});
  ASSERT_GT(grains.vertex_count(), 50 * vertices_per_grain);
  for (std::size_t v = 0; v < grains.vertex_count(); v += vertices_per_grain) {
    const glm::vec3 tail = grains.position[v], tip = grains.position[v + vertices_per_grain - 1];
    EXPECT_GT(tip.y - tail.y, 0.5f * 0.004f);
    EXPECT_NEAR(glm::distance(tail, tip), 0.004, 1e-7);
    EXPECT_NEAR(glm::distance(glm::dvec3(tip), middle), glm::distance(glm::dvec3(tail), middle), 1e-4);
    // Grains lie within the band: 0.3 of the meridian is 54 degrees from the pole.
    const float y = 0.5f * (tip.y + tail.y);
    EXPECT_GT(y, 0.04 * (1 - 0.588) - 1e-4);
    EXPECT_LT(y, 0.04 * (1 + 0.588) + 1e-4);
  }
}

TEST(Grains, OnTheBackTheyPointInwards) {
  GrainSketch sketch = seeds(0.01);
  sketch.on_front = false;
  sketch.stance.sink = -0.002;
  sketch.stance.tilt = 0.5;
  const DiffusionSurfaces grains = scatter_grains(seeded(sketch), {2, 0});
  for (std::size_t v = 0; v < grains.vertex_count(); v += vertices_per_grain) {
    const glm::dvec3 tail(grains.position[v]), tip(grains.position[v + vertices_per_grain - 1]);
    EXPECT_LT(glm::distance(tip, middle), glm::distance(tail, middle));
    EXPECT_NEAR(glm::distance(0.5 * (tip + tail), middle), 0.038, 2e-4);
  }
}

TEST(Grains, InFoldsEachChamberGetsItsOwn) {
  std::vector<Curve> loops{circle_at({0, 0.03}, 0.01), circle_at({0, -0.03}, 0.01)};
  Template made = fruit({in_fold(circle_at({0.03, 0.04}, 0.01), loops)}, 2);
  GrainSketch sketch = seeds(0.004);
  sketch.on_front = false;
  made.grains = {sketch};
  const std::vector<glm::dvec3> at = centers(scatter_grains(made, {1, 0}));
  const auto first = std::count_if(at.begin(), at.end(), [](const glm::dvec3& p) { return p.z < 0; });
  EXPECT_GT(first, 30);
  EXPECT_NEAR(static_cast<double>(first), static_cast<double>(at.size()) / 2, 10);
}

TEST(Grains, TooManyOrTooFineIsRefusedAtOnce) {
  const auto message = [](double radius) {
    try {
      scatter_grains(seeded(seeds(radius)), {});
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(message(1e-5), testing::HasSubstr("grains \"seeds\": their spacing"));
  EXPECT_THAT(message(0), testing::HasSubstr("their spacing"));
  EXPECT_THAT(message(0.0003), testing::HasSubstr("more than 20 000"));
}

/// The mistake is found only while growing, but reported at its place in the template.
TEST(Grains, TooFineIsToldAtItsPlaceInTheTemplate) {
  const TemporaryFolder folder;
  Template made = seeded(seeds(1e-5));
  made.file = folder / "x.toml";
  std::ofstream(made.file) << "format = 1\n\n[[grains]]\nname = \"pits\"\n[[grains]]\nname = \"seeds\"\n";
  try {
    scatter_grains(made, {});
    ADD_FAILURE() << "was grown";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::StartsWith(made.file + ":6:8: error: grains \"seeds\""));
  }
}

TEST(Grains, AnEmptyBandHasNone) {
  GrainSketch sketch = seeds(0.004);
  sketch.ground.along_from = 0.6;
  sketch.ground.along_to = 0.4;
  EXPECT_EQ(scatter_grains(seeded(sketch), {}).triangle_count(), 0u);
}

}  // namespace
}  // namespace pomona
