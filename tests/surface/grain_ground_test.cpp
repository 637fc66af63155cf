// Where grains grow, how densely, and how far apart.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/mesh/enclosures.h"
#include "generator/surface/grains/grains.h"
#include "generator/surface/sweep/dart_throwing.h"
#include "generator/surface/sweep/surface_grids.h"
#include "generator/surface/sweep/sweep.h"
#include "tests/surface/sketches.h"

namespace pomona {
namespace {

using namespace sketches;

GrainSketch round_grains(double poisson_radius) {
  GrainSketch sketch;
  sketch.name = "seeds";
  sketch.spacing.poisson_radius = poisson_radius;
  sketch.form.length = sketch.form.width = sketch.form.thickness = 0.001;
  sketch.front = {0, {Ramp<Color>::constant(Color(0.9f, 0.8f, 0.5f))}, false};
  sketch.back = {1, {Ramp<Color>::constant(Color(1))}, false};
  return sketch;
}

/// A ball of 8 cm, optionally with folds.
Template ball(int folds = 0) { return fruit({around_axis(meridian(0.04), circle(1))}, folds); }

/// The darts of one sketch over the first surface of a fruit.
std::vector<Dart> darts_on(const Template& fruit, const GrainSketch& sketch, std::span<const Dart> others = {}) {
  const std::vector<SweptGrid> grids = swept_grids(fruit, fruit.surfaces.front(), {});
  const GrainDraws draws = grain_draws({5, 0}, sketch.name);
  return thrown_darts(grain_targets(grids, sketch, draws.folds), sketch, draws, {2}, others);
}

/// The place of a point along a ball's meridian, from the bottom, 0..1.
double share_along(const glm::dvec3& p) { return reproducible::acos(std::clamp((0.04 - p.y) / 0.04, -1.0, 1.0)) / pi; }

double fold_angle(const glm::dvec3& p) {
  const double angle = reproducible::atan2(-p.z, p.x);
  return angle < 0 ? angle + 2 * pi : angle;
}

/// Where a surface folds back onto itself, its normals may cancel to 0.
TEST(ThrownDarts, FallNowhereWithoutASide) {
  GrainTarget target;
  target.corner[1].position = {0.01, 0, 0};
  target.corner[2].position = {0, 0, 0.01};
  const GrainSketch sketch = round_grains(0.002);
  EXPECT_TRUE(thrown_darts({target}, sketch, grain_draws({5, 0}, sketch.name), {}).empty());
  for (GrainPlace& place : target.corner) place.normal = {0, 1e-9, 0};
  EXPECT_GT(thrown_darts({target}, sketch, grain_draws({5, 0}, sketch.name), {}).size(), 5u) << "of any length";
}

TEST(GrainDensity, CountsFollowItsIntegral) {
  const double full = static_cast<double>(darts_on(ball(), round_grains(0.0015)).size());
  for (const double density : {0.5, 0.25, 0.1}) {
    GrainSketch sketch = round_grains(0.0015);
    sketch.ground.density_along = Ramp<double>::constant(density);
    EXPECT_NEAR(static_cast<double>(darts_on(ball(), sketch).size()), density * full, 0.04 * density * full) << density;
  }

  // The density rises from 0 at the bottom to 1 at the top: half of all places, by symmetry.
  GrainSketch sketch = round_grains(0.0015);
  sketch.ground.density_along = {{{0, 0}, {1, 1}}};
  EXPECT_NEAR(static_cast<double>(darts_on(ball(), sketch).size()), 0.5 * full, 0.03 * 0.5 * full);
}

TEST(GrainDensity, FollowsItsRampFromBandToBand) {
  GrainSketch sketch = round_grains(0.0012);
  sketch.ground.density_along = {{{0, 0.1}, {1, 1}}};
  std::array<double, 4> count{};
  for (const Dart& dart : darts_on(ball(), sketch)) {
    ++count[std::min<std::size_t>(3, static_cast<std::size_t>(4 * share_along(dart.center)))];
  }
  for (std::size_t band = 0; band < 4; ++band) {
    // The integral of the ramp over the band's share of the sphere, whose element is sin(pi t) pi / 2.
    double expected = 0;
    for (int i = 0; i < 1000; ++i) {
      const double t = (static_cast<double>(band) + (i + 0.5) / 1000) / 4;
      expected += (0.1 + 0.9 * t) * reproducible::sin(pi * t) * pi / 2 / 4000;
    }
    expected *= 0.7 * 4 * pi * 0.04 * 0.04 / (0.0012 * 0.0012);
    EXPECT_NEAR(count[band], expected, 0.06 * expected) << band;
  }
}

TEST(GrainDensity, AroundItRepeatsInEveryFold) {
  GrainSketch sketch = round_grains(0.002);
  sketch.ground.density_around = {{{0, 0}, {0.5, 0}, {0.5001, 1}, {1, 1}}};
  const std::vector<Dart> darts = darts_on(ball(4), sketch);
  std::array<int, 4> count{};
  for (const Dart& dart : darts) {
    const double folds = 4 * fold_angle(dart.center) / (2 * pi);
    EXPECT_GT(folds - std::floor(folds), 0.499);
    ++count[std::min<std::size_t>(3, static_cast<std::size_t>(folds))];
  }
  for (const int in_fold : count) EXPECT_NEAR(in_fold, 0.25 * static_cast<double>(darts.size()), 30);
}

TEST(GrainDensity, TwoAreNeverNearerThanTheMeanOfTheirSpacings) {
  GrainSketch sketch = round_grains(0.002);
  sketch.ground.density_along = {{{0, 0.02}, {0.5, 1}, {0.6, 0.3}, {1, 0.3}}};
  sketch.stance.sink = 0.003;
  const std::vector<Dart> darts = darts_on(ball(), sketch);
  ASSERT_GT(darts.size(), 500u);
  double widest = 0;
  for (std::size_t i = 0; i < darts.size(); ++i) {
    EXPECT_GE(darts[i].spacing, 0.002);
    widest = std::max(widest, darts[i].spacing);
    for (std::size_t j = 0; j < i; ++j) {
      ASSERT_GE(glm::distance(darts[i].center, darts[j].center), 0.5 * (darts[i].spacing + darts[j].spacing));
    }
  }
  EXPECT_GT(widest, 0.006);
}

TEST(GrainDensity, BelowOnePercentThereAreNone) {
  GrainSketch sketch = round_grains(0.002);
  sketch.ground.density_along = Ramp<double>::constant(0.009);
  EXPECT_TRUE(darts_on(ball(), sketch).empty());
}

TEST(GrainLimits, ASectorMayRunThroughTheStart) {
  GrainSketch sketch = round_grains(0.003);
  sketch.ground.around_from = 0.9;
  sketch.ground.around_to = 0.2;
  const std::vector<Dart> darts = darts_on(ball(), sketch);
  const double full = static_cast<double>(darts_on(ball(), round_grains(0.003)).size());
  for (const Dart& dart : darts) {
    const double turn = fold_angle(dart.center) / (2 * pi);
    EXPECT_TRUE(turn > 0.899 || turn < 0.201) << turn;
  }
  EXPECT_NEAR(static_cast<double>(darts.size()), 0.3 * full, 0.05 * full);
}

TEST(GrainLimits, OnlyTheFoldsNamedHaveGrains) {
  GrainSketch sketch = round_grains(0.003);
  sketch.ground.folds = {1, 3};
  const std::vector<Dart> darts = darts_on(ball(4), sketch);
  EXPECT_GT(darts.size(), 500u);
  for (const Dart& dart : darts) {
    const int fold = static_cast<int>(4 * fold_angle(dart.center) / (2 * pi) + 1e-6);
    EXPECT_TRUE(fold == 1 || fold == 3) << fold;
  }
}

/// A chamber in each of two folds.
Template chambers() {
  const std::vector<Curve> loops{circle_at({0, 0.03}, 0.01), circle_at({0, -0.03}, 0.01)};
  return fruit({in_fold(circle_at({0.03, 0.04}, 0.01), loops)}, 2);
}

/// How many vertices of grains lie in no chamber, and how many grains there are.
std::pair<int, std::size_t> outside_and_count(const Template& made) {
  const DiffusionSurfaces walls = sweep(made), grains = scatter_grains(made, {});
  std::vector<Enclosures::Triangle> triangles;
  for (const glm::uvec3& t : walls.triangle)
    triangles.push_back({{walls.position[t.x], walls.position[t.y], walls.position[t.z]}, 0});
  const Enclosures chamber(triangles);
  int outside = 0;
  for (const glm::vec3& p : grains.position) outside += chamber.around(glm::dvec3(p)).empty();
  return {outside, grains.vertex_count()};
}

/// Grains must not pass through a wall, as pips of lemons once did through two segments.
TEST(GrainWalls, KeepGrainsOnTheirSide) {
  Template made = chambers();
  for (const double sink : {-0.001, 0.0, 0.001}) {
    GrainSketch sketch = round_grains(0.004);
    sketch.on_front = sink == 0.001;
    sketch.stance.sink = sink;
    sketch.form = {.length = 0.004, .width = 0.003, .thickness = 0.002};
    made.grains = {sketch};
    const auto [outside, all] = outside_and_count(made);
    EXPECT_GT(outside, 0);
    made.grains[0].spacing.clear_of = {0};
    const auto [outside_then, all_then] = outside_and_count(made);
    EXPECT_EQ(outside_then, 0) << sink;
    EXPECT_GT(all_then, all * 6 / 10) << sink;
  }
}

TEST(GrainWalls, LeaveGrainsAloneThatAreClear) {
  Template made = chambers();
  GrainSketch sketch = round_grains(0.004);
  sketch.on_front = false;
  sketch.stance.sink = -0.004;
  sketch.form = {.length = 0.002, .width = 0.002, .thickness = 0.002};
  made.grains = {sketch};
  const DiffusionSurfaces before = scatter_grains(made, {});
  made.grains[0].spacing.clear_of = {0};
  EXPECT_EQ(scatter_grains(made, {}).position, before.position);
}

TEST(GrainLimits, DepthTellsTheInnerArcFromTheOuter) {
  for (const bool outer : {false, true}) {
    GrainSketch sketch = round_grains(0.002);
    sketch.ground.depth_from = outer ? 0.6 : 0;
    sketch.ground.depth_to = outer ? 1 : 0.4;
    const std::vector<Dart> darts = darts_on(chambers(), sketch);
    EXPECT_GT(darts.size(), 50u);
    for (const Dart& dart : darts) {
      const double radius = std::sqrt(dart.center.x * dart.center.x + dart.center.z * dart.center.z);
      EXPECT_EQ(radius > 0.03, outer) << radius;
    }
  }
}

TEST(GrainLimits, FacingKeepsThoseThatPointToTheAxis) {
  GrainSketch sketch = round_grains(0.002);
  sketch.ground.facing = GrainGround::Facing::towards_axis;
  const std::vector<Dart> darts = darts_on(chambers(), sketch);
  EXPECT_GT(darts.size(), 50u);
  for (const Dart& dart : darts) {
    EXPECT_LT(dart.normal.x * dart.center.x + dart.normal.z * dart.center.z, 0);
  }
}

TEST(GrainLimits, SharesLeaveSomePlacesAndSomeFoldsEmpty) {
  Template made = ball(16);
  GrainSketch sketch = round_grains(0.002);
  made.grains = {sketch};
  const double full = static_cast<double>(scatter_grains(made, {1, 0}).triangle_count());
  made.grains[0].ground.share = 0.3;
  EXPECT_NEAR(static_cast<double>(scatter_grains(made, {1, 0}).triangle_count()), 0.3 * full, 0.03 * full);

  sketch.ground.fold_share = 0.5;
  std::array<int, 16> count{};
  for (const Dart& dart : darts_on(made, sketch))
    ++count[static_cast<std::size_t>(16 * fold_angle(dart.center) / (2 * pi))];
  const auto empty = std::count_if(count.begin(), count.end(), [](int n) { return n < 10; });
  EXPECT_GE(empty, 4);
  EXPECT_LE(empty, 12);
}

TEST(GrainSpacingRule, MayHoldWhateverTheyFace) {
  // In a chamber of only 8 mm, grains on opposite walls come near each other.
  const std::vector<Curve> loops{circle_at({0, 0.03}, 0.004), circle_at({0, -0.03}, 0.004)};
  const Template thin = fruit({in_fold(circle_at({0.03, 0.04}, 0.004), loops)}, 2);
  const auto nearest = [](const std::vector<Dart>& darts) {
    double min = 1;
    for (std::size_t i = 0; i < darts.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) min = std::min(min, glm::distance(darts[i].center, darts[j].center));
    }
    return min;
  };
  GrainSketch sketch = round_grains(0.005);
  sketch.stance.sink = 0.003;
  EXPECT_LT(nearest(darts_on(thin, sketch)), 0.005);
  sketch.spacing.any_facing = true;
  EXPECT_GE(nearest(darts_on(thin, sketch)), 0.005);
}

TEST(GrainSpacingRule, OneKindGivesWayToAnother) {
  const std::vector<Dart> first = darts_on(ball(), round_grains(0.01));
  GrainSketch sketch = round_grains(0.004);
  sketch.name = "others";
  const std::vector<Dart> second = darts_on(ball(), sketch, first);
  ASSERT_GT(second.size(), 50u);
  for (const Dart& dart : second) {
    for (const Dart& other : first) ASSERT_GE(glm::distance(dart.center, other.center), 0.007);
  }
}

TEST(GrainSpacingRule, SolidGrainsDoNotOverlap) {
  GrainSketch sketch = round_grains(0.003);
  sketch.form = {.length = 0.009, .width = 0.005, .thickness = 0.003, .size_jitter = 0.3};
  sketch.stance.angle_jitter = pi;
  sketch.stance.tilt_jitter = 1;
  const auto overlaps = [](const std::vector<Dart>& darts) {
    int found = 0;
    for (std::size_t i = 0; i < darts.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (glm::distance(darts[i].center, darts[j].center) > 0.012) continue;  // longer than any grain
        found += ellipsoids_overlap(darts[i].center, darts[i].pose, darts[j].center, darts[j].pose) ? 1 : 0;
      }
    }
    return found;
  };
  EXPECT_GT(overlaps(darts_on(ball(), sketch)), 500);
  sketch.spacing.solid = true;
  const std::vector<Dart> solid = darts_on(ball(), sketch);
  EXPECT_EQ(overlaps(solid), 0);
  EXPECT_GT(solid.size(), 200u);
}

TEST(GrainSpacingRule, EllipsoidsOverlapWhenTheyDo) {
  const GrainPose ball{{0.001, 0, 0}, {0, 0.001, 0}, {0, 0, 0.001}};
  const GrainPose needle{{0.0001, 0, 0}, {0, 0.005, 0}, {0, 0, 0.0001}};
  EXPECT_TRUE(ellipsoids_overlap({0, 0, 0}, ball, {0.0019, 0, 0}, ball));
  EXPECT_FALSE(ellipsoids_overlap({0, 0, 0}, ball, {0.0021, 0, 0}, ball));
  EXPECT_TRUE(ellipsoids_overlap({0, 0, 0}, ball, {0, 0.0059, 0}, needle));
  EXPECT_FALSE(ellipsoids_overlap({0, 0, 0}, ball, {0, 0.0061, 0}, needle));
  EXPECT_FALSE(ellipsoids_overlap({0, 0, 0}, ball, {0.0012, 0, 0}, needle));
}

/// An ellipsoid of radii 0.2 to 1, turned at random.
GrainPose some_pose(const RandomStream& random, std::uint64_t& draw) {
  const glm::dvec3 a =
      glm::normalize(glm::dvec3(random.normal(draw), random.normal(draw + 1), random.normal(draw + 2)));
  const glm::dvec3 b = glm::normalize(glm::cross(a, {random.normal(draw + 3), 1, random.normal(draw + 4)}));
  const auto radius = [&](std::uint64_t k) { return 0.2 + 0.8 * random.uniform(draw + k); };
  const GrainPose pose{a * radius(5), b * radius(6), glm::cross(a, b) * radius(7)};
  draw += 8;
  return pose;
}

/// The distance of the ellipsoid's surface from its centre.
double reach_towards(const GrainPose& pose, const glm::dvec3& way) {
  return glm::length(glm::dvec3(glm::dot(pose.thickness, way), glm::dot(pose.length, way), glm::dot(pose.width, way)));
}

/// 1 on the ellipsoid about the origin, less inside.
double level_at(const GrainPose& pose, const glm::dvec3& place) {
  const auto share = [&](const glm::dvec3& axis) { return glm::dot(place, axis) / glm::dot(axis, axis); };
  return glm::length(glm::dvec3(share(pose.thickness), share(pose.length), share(pose.width)));
}

TEST(GrainSpacingRule, EllipsoidsOverlapWhereAPointLiesInBothAndNotWhereAPlaneParts) {
  const RandomStream random({7, 0}, "ellipsoids");
  std::uint64_t draw = 0;
  int together = 0, apart = 0;
  for (int pair = 0; pair < 4000; ++pair) {
    const GrainPose one = some_pose(random, draw), other = some_pose(random, draw);
    const glm::dvec3 away =
        2.2 * glm::dvec3(random.uniform(draw) - 0.5, random.uniform(draw + 1) - 0.5, random.uniform(draw + 2) - 0.5);
    draw += 3;
    bool meet = false, parted = false;
    for (std::uint64_t k = 0; k < 2000 && !meet && !parted; ++k) {
      const glm::dvec3 way = glm::normalize(
          glm::dvec3(random.normal(1000000 + 3 * k), random.normal(1000001 + 3 * k), random.normal(1000002 + 3 * k)));
      parted = glm::dot(way, away) > reach_towards(one, way) + reach_towards(other, way);
      const glm::dvec3 inside = way * (std::cbrt(random.uniform(k)) / level_at(one, way));
      meet = level_at(other, inside - away) < 1;
    }
    if (meet || parted) {
      EXPECT_EQ(ellipsoids_overlap({0, 0, 0}, one, away, other), meet) << "pair " << pair;
    }
    together += meet ? 1 : 0;
    apart += parted ? 1 : 0;
  }
  EXPECT_GT(together, 1000);
  EXPECT_GT(apart, 400);
}

TEST(GrainSpacingRule, AKindDoesNotChangeForAnotherThatJoins) {
  Template made = ball();
  made.grains = {round_grains(0.005)};
  const DiffusionSurfaces alone = scatter_grains(made, {3, 0});
  GrainSketch late = round_grains(0.004);
  late.name = "late";
  late.spacing.apart_from = {0};
  made.grains.push_back(late);
  const DiffusionSurfaces both = scatter_grains(made, {3, 0});
  ASSERT_GT(both.vertex_count(), alone.vertex_count());
  EXPECT_TRUE(std::equal(alone.position.begin(), alone.position.end(), both.position.begin()));
}

TEST(GrainLimits, AMillionGrainsAreRefusedBeforeTheFirstDart) {
  Template made = ball();
  made.grains = {round_grains(0.0001)};  // 1 400 000 grains
  made.grains[0].ground.density_along = {{{0, 0.7}, {1, 1}}};
  try {
    scatter_grains(made, {});
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("more than 20 000"), std::string::npos);
  }
}

}  // namespace
}  // namespace pomona
