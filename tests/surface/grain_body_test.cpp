// The shapes of grains, how they lie, and their colours.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/base/units.h"
#include "generator/surface/bodies.h"
#include "generator/surface/grains/grain_colors.h"
#include "generator/surface/grains/grain_shape.h"
#include "generator/surface/grains/grains.h"
#include "tests/surface/sketches.h"

namespace pomona {
namespace {

using namespace sketches;

/// A ball of 8 cm with drops on it: 4 mm long, 2 mm wide, 1 mm thick.
Template seeded() {
  Template made = fruit({around_axis(meridian(0.04), circle(1))});
  GrainSketch sketch;
  sketch.name = "seeds";
  sketch.spacing.poisson_radius = 0.006;
  sketch.form = {.length = 0.004, .width = 0.002, .thickness = 0.001};
  sketch.front = {0, {Ramp<Color>::constant(Color(0.5f, 0.2f, 0.1f))}, false};
  sketch.back = {1, {Ramp<Color>::constant(Color(0.6f, 0.6f, 0.3f))}, false};
  made.grains = {sketch};
  return made;
}

constexpr std::size_t per_grain = 2 + 8 * 4;

double volume(const SweptGrid& grid) {
  double six = 0;
  for (const glm::uvec3& t : grid.triangle) {
    six += glm::dot(grid.position[t.x], glm::cross(grid.position[t.y], grid.position[t.z]));
  }
  return six / 6;
}

TEST(GrainShapes, HoldTheVolumesOfTheirFormulas) {
  struct Expected {
    GrainShape shape;
    double pointedness, volume;
  };
  const Expected all[] = {
      {GrainShape::ellipsoid, 0, 4 * pi / 3},
      {GrainShape::ellipsoid, 1, pi * 2 / (3 * 0.7698 * 0.7698)},  // pi int sin^2 t sin^2(t/2) / 0.7698^2 sin t dt
      {GrainShape::lens, 0, pi},                                   // 2 int (1 - r^2) 2 pi r dr
      {GrainShape::disc, 0, pi * pi / 2},                          // 2 int sqrt(1 - r^4) 2 pi r dr
      {GrainShape::rod, 0, pi * 2 * 0.8740191847640398},           // pi int sqrt(1 - y^4) dy: a lemniscate's
      {GrainShape::spindle, 0, pi * 16 / 15},                      // pi int (1 - y^2)^2 dy
      {GrainShape::bean, 0, 0.8 * 4 * pi / 3},                     // sheared: as an ellipsoid of 0.8 the width
      {GrainShape::cushion, 0, 6.481987351786382},                 // (2 Gamma(5/4))^3 / Gamma(7/4)
  };
  for (const Expected& expected : all) {
    GrainForm form;
    form.shape = expected.shape;
    form.pointedness = expected.pointedness;
    form.around = form.along = 64;
    EXPECT_NEAR(volume(unit_grain(form)), expected.volume, 0.01 * expected.volume) << static_cast<int>(expected.shape);
  }
}

TEST(GrainShapes, AreClosedWithTheFrontOutside) {
  for (int shape = 0; shape <= static_cast<int>(GrainShape::cushion); ++shape) {
    for (const double pointedness : {0.0, 0.6, 1.0}) {
      Template made = seeded();
      made.grains[0].form.shape = static_cast<GrainShape>(shape);
      made.grains[0].form.pointedness = pointedness;
      made.grains[0].spacing.poisson_radius = 0.03;
      made.grains[0].front.hidden = true;
      const Bodies found = find_bodies(scatter_grains(made, {}));
      ASSERT_GT(found.bodies.size(), 4u);
      for (const Bodies::Body& body : found.bodies) {
        EXPECT_TRUE(body.closed);
        EXPECT_GT(body.volume, 0);
      }
    }
  }
}

TEST(GrainShapes, FillTheirBoxAndNoMore) {
  for (int shape = 0; shape <= static_cast<int>(GrainShape::cushion); ++shape) {
    GrainForm form;
    form.shape = static_cast<GrainShape>(shape);
    form.around = form.along = 32;
    for (const glm::dvec3& p : unit_grain(form).position) {
      for (int k = 0; k < 3; ++k) EXPECT_LE(std::fabs(p[k]), 1 + 1e-12) << shape;
    }
  }
}

/// The vector from tail to tip of each grain.
std::vector<glm::dvec3> axes(const DiffusionSurfaces& grains) {
  std::vector<glm::dvec3> found;
  for (std::size_t v = 0; v < grains.vertex_count(); v += per_grain) {
    found.push_back(glm::dvec3(grains.position[v + per_grain - 1]) - glm::dvec3(grains.position[v]));
  }
  return found;
}

TEST(GrainStance, HeadsWhereItIsTold) {
  Template made = seeded();
  using Heading = GrainStance::Heading;
  for (const Heading heading : {Heading::towards_axis, Heading::from_axis, Heading::up, Heading::down}) {
    made.grains[0].stance.heading = heading;
    const DiffusionSurfaces grains = scatter_grains(made, {});
    std::size_t v = 0;
    for (const glm::dvec3& axis : axes(grains)) {
      const glm::dvec3 tail(grains.position[v]);
      v += per_grain;
      EXPECT_NEAR(glm::length(axis), 0.004, 1e-7);
      if (heading == Heading::up || heading == Heading::down) {
        EXPECT_NEAR(axis.y, heading == Heading::up ? 0.004 : -0.004, 1e-7);
        continue;
      }
      EXPECT_NEAR(axis.y, 0, 1e-7);
      const glm::dvec3 middle = tail + 0.5 * axis;
      const double inwards =
          -(axis.x * middle.x + axis.z * middle.z) / std::sqrt(middle.x * middle.x + middle.z * middle.z);
      EXPECT_NEAR(inwards, heading == Heading::towards_axis ? 0.004 : -0.004, 1e-7);
    }
  }
}

TEST(GrainStance, TheFlatSideFacesAroundIfTold) {
  const GrainDraws draws = grain_draws({}, "seeds");
  GrainSketch sketch = seeded().grains[0];
  sketch.stance.heading = GrainStance::Heading::towards_axis;
  sketch.stance.flat = GrainStance::Flat::around;
  const GrainPose pose = grain_pose(sketch, {{0.03, 0.01, 0}, {1, 0, 0}, {0, 1, 0}, 7}, draws);
  EXPECT_LT(glm::distance(pose.length, {-0.002, 0, 0}), 1e-12);
  EXPECT_NEAR(std::fabs(pose.thickness.z), 0.0005, 1e-12);
  EXPECT_NEAR(std::fabs(pose.width.y), 0.001, 1e-12);
}

TEST(GrainStance, AFixedAngleTurnsThemAll) {
  Template made = seeded();
  made.grains[0].stance.angle = pi / 2;
  made.grains[0].ground.along_from = 0.3;
  made.grains[0].ground.along_to = 0.7;
  for (const glm::dvec3& axis : axes(scatter_grains(made, {}))) EXPECT_NEAR(axis.y, 0, 2e-4);
}

TEST(GrainJitter, StaysWithinItsBoundsAndUsesThem) {
  const GrainDraws draws = grain_draws({2, 0}, "seeds");
  GrainSketch sketch = seeded().grains[0];
  sketch.form.size_jitter = 0.2;
  sketch.form.length_jitter = 0.5;
  sketch.form.width_jitter = 0.3;
  sketch.stance.tilt_jitter = 0.4;
  double min = 9, max = 0, steepest = 0;
  for (std::uint64_t n = 0; n < 2000; ++n) {
    const GrainPose pose = grain_pose(sketch, {{0.03, 0, 0}, {1, 0, 0}, {0, 1, 0}, n}, draws);
    const double size = glm::length(pose.thickness) / 0.0005;
    ASSERT_TRUE(size >= 0.8 && size <= 1.2);
    const double longer = glm::length(pose.length) / (0.002 * size);
    ASSERT_TRUE(longer >= 0.5 && longer <= 1.5);
    const double wider = glm::length(pose.width) / (0.001 * size);
    ASSERT_TRUE(wider >= 0.7 - 1e-9 && wider <= 1.3 + 1e-9);
    min = std::min(min, longer);
    max = std::max(max, longer);
    steepest = std::max(steepest, std::fabs(pose.length.x) / glm::length(pose.length));
  }
  EXPECT_LT(min, 0.51);
  EXPECT_GT(max, 1.49);
  EXPECT_LE(steepest, 0.38942);  // sin 0.4
  EXPECT_GT(steepest, 0.38);
}

TEST(GrainColors, JitterStaysInTheGamutAndNearTheColor) {
  for (const Color& color : {Color(1, 0, 0), Color(0, 0, 1), Color(1), Color(0), Color(0.4f, 0.5f, 0.1f)}) {
    for (const double lightness : {-0.1, 0.0, 0.1}) {
      for (const double hue : {-0.5, 0.0, 3.0}) {
        const Color made = tinted(color, {lightness, hue});
        for (int k = 0; k < 3; ++k) EXPECT_TRUE(made[k] >= 0 && made[k] <= 1);
        const double wanted = std::clamp(to_oklab(color).x + lightness, 0.0, 1.0);
        EXPECT_NEAR(to_oklab(made).x, wanted, 0.02);
      }
    }
  }
  EXPECT_EQ(tinted(Color(0.3f, 0.2f, 0.1f), {}), Color(0.3f, 0.2f, 0.1f));
}

TEST(GrainColors, EachGrainHasItsOwn) {
  Template made = seeded();
  made.grains[0].lightness_jitter = 0.05;
  made.grains[0].hue_jitter = 0.3;
  const DiffusionSurfaces grains = scatter_grains(made, {});
  const double own = to_oklab(Color(0.6f, 0.6f, 0.3f)).x;
  double min = 1, max = 0;
  for (std::size_t v = 0; v < grains.vertex_count(); ++v) {
    EXPECT_EQ(grains.back_color[v], grains.back_color[v / per_grain * per_grain]);
    const double lightness = to_oklab(grains.back_color[v]).x;
    EXPECT_NEAR(lightness, own, 0.051);
    min = std::min(min, lightness);
    max = std::max(max, lightness);
  }
  EXPECT_GT(max - min, 0.08);
}

TEST(GrainLooks, HaveTheirShareColorAndSize) {
  Template made = seeded();
  made.grains[0].spacing.poisson_radius = 0.002;
  const Color pale(0.9f, 0.9f, 0.8f);
  made.grains[0].looks = {{0.25, 0.5, {Ramp<Color>::constant(pale)}, {Ramp<Color>::constant(pale)}}};
  const DiffusionSurfaces grains = scatter_grains(made, {});
  double total = 0, odd = 0;
  std::size_t v = 0;
  for (const glm::dvec3& axis : axes(grains)) {
    const bool is_odd = grains.back_color[v] == pale;
    EXPECT_NEAR(glm::length(axis), is_odd ? 0.002 : 0.004, 1e-6);
    ++total;
    odd += is_odd ? 1 : 0;
    v += per_grain;
  }
  EXPECT_NEAR(odd / total, 0.25, 0.03);
}

TEST(GrainCores, LieWithinEveryGrainOfItsOwnLook) {
  Template made = seeded();
  GrainCore core;
  core.form = {.length = 0.6, .width = 0.5, .thickness = 0.5};
  core.shift = 0.1;
  core.front = core.back = made.grains[0].back;
  made.grains[0].cores = {core};
  made.grains[0].looks = {{0.5, 1, made.grains[0].front.color, made.grains[0].back.color}};
  made.grains[0].stance.angle_jitter = 3;
  const DiffusionSurfaces grains = scatter_grains(made, {});
  ASSERT_EQ(grains.surface_names, (std::vector<std::string>{"seeds", "seeds-core"}));
  const auto first_core =
      static_cast<std::size_t>(std::find(grains.surface.begin(), grains.surface.end(), 1) - grains.surface.begin());
  const std::size_t begin = grains.triangle[first_core].x / per_grain * per_grain;
  const std::size_t cores = (grains.vertex_count() - begin) / per_grain, all = begin / per_grain;
  EXPECT_NEAR(static_cast<double>(cores), 0.5 * static_cast<double>(all), 0.1 * static_cast<double>(all));

  // Each lies on the line from tail to tip of one grain, a tenth of its length from the middle.
  for (std::size_t v = begin; v < grains.vertex_count(); v += per_grain) {
    double nearest = 1;
    const glm::dvec3 low(grains.position[v]), high(grains.position[v + per_grain - 1]);
    for (std::size_t g = 0; g < begin; g += per_grain) {
      const glm::dvec3 tail(grains.position[g]), tip(grains.position[g + per_grain - 1]);
      nearest = std::min(
          nearest, glm::distance(tail + 0.3 * (tip - tail), low) + glm::distance(tail + 0.9 * (tip - tail), high));
    }
    EXPECT_LT(nearest, 1e-7);
  }
}

}  // namespace
}  // namespace pomona
