// How a peeler works: the depth below the skin, the spiral about the axis, and the offset that results.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/units.h"
#include "generator/knife/peel_depth.h"
#include "generator/knife/skin_offset.h"
#include "generator/knife/spiral.h"
#include "generator/surface/skin_depth.h"
#include "tests/knife/closed_surface_checks.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

DiffusionSurfaces ball(double radius, int n = 24) { return shapes::sphere(radius, n, shapes::skin_paint()); }

DiffusionSurfaces ball_with_stem() {
  return joined(ball(0.03), shapes::box({-0.002, 0.025, -0.002}, {0.002, 0.05, 0.002}, 2, shapes::skin_paint()));
}

TEST(PeelDepth, InABallGrowsTowardsItsMiddle) {
  const PeelDepth depth(ball(0.03), 0.002, 0.001);
  const glm::dvec3 way = glm::normalize(glm::dvec3(1, -2, 3));
  for (const double from_middle : {0.005, 0.02, 0.028, 0.031, 0.05}) {
    const PeelDepth::Place place = depth.at(from_middle * way);
    EXPECT_NEAR(place.depth, 0.03 - from_middle, 1e-4) << "negative outside";
    EXPECT_NEAR(glm::length(place.deeper), 1, 1e-12);
    EXPECT_LT(glm::dot(place.deeper, way), -0.95);
    EXPECT_EQ(depth.below_skin(from_middle * way), place.depth) << "nothing stays on a ball";
    EXPECT_EQ(depth.from_what_stays(from_middle * way, 0.01), 0.01);
  }
}

/// At parts that are kept, the depth is the peel's plus the clearance; it decreases with the distance from them.
TEST(PeelDepth, AroundAStemIsMoreThanThePeel) {
  const PeelDepth depth(ball_with_stem(), 0.002, 0.001);
  EXPECT_NEAR(depth.box().high.y, 0.05, 1e-9);
  EXPECT_NEAR(depth.skin().box().high.y, 0.03, 1e-9);
  for (const double beside : {0.0, 0.0004, 0.0008}) {
    const glm::dvec3 point(0.002 + beside, 0.04, 0);
    EXPECT_NEAR(depth.at(point).depth, 0.003 - beside, 1e-9);
    EXPECT_NEAR(glm::distance(depth.at(point).deeper, {-1, 0, 0}), 0, beside > 0 ? 1e-6 : 1.0);
    EXPECT_NEAR(depth.from_what_stays(point, 0.01), beside, 1e-9);
    EXPECT_NEAR(depth.below_skin(point), 0.03 - glm::length(point), 1e-4);
  }
  EXPECT_EQ(depth.from_what_stays({0.03, 0, 0}, 0.005), 0.005) << "farther off than asked";
}

TEST(PeelDepth, WantsAClosedSkin) {
  EXPECT_THROW(PeelDepth(shapes::open_sheet(0.1, 0.02, 2, shapes::skin_paint()), 0.002, 0.001), Error);
}

/// A bunch has no one skin: its largest berry would be peeled among the others, each of which the grid would be
/// measured against.
TEST(PeelDepth, WantsAMainBody) {
  const auto beside = [](float x) {
    DiffusionSurfaces other = ball(0.028);
    for (glm::vec3& p : other.position) p.x += x;
    return other;
  };
  const DiffusionSurfaces two = joined(ball(0.03), beside(0.07f)), three = joined(two, beside(-0.07f));
  EXPECT_NO_THROW(PeelDepth(two, 0.002, 0.001));
  try {
    PeelDepth(three, 0.002, 0.001);
    FAIL() << "was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::usage);
    EXPECT_NE(std::string(error.what()).find("lies in 2 bodies beside its largest"), std::string::npos);
  }
}

/// On a ball: the angle from its bottom times its radius, for points inside and outside.
TEST(OutlinePlace, OnABallIsAnArcsLength) {
  const DiffusionSurfaces fruit = ball(0.03);
  const OutlinePlace outline{SkinDepth(fruit).skin()};
  EXPECT_NEAR(outline.length(), pi * 0.03, 1e-3 * outline.length());
  for (const double share : {0.02, 0.25, 0.5, 0.8, 0.98}) {
    const double angle = pi * share;
    for (const double radius : {0.01, 0.03, 0.05}) {
      for (const double turn : {0.0, 2.0, 4.5}) {
        const glm::dvec3 point =
            radius * glm::dvec3(std::sin(angle) * std::cos(turn), -std::cos(angle), std::sin(angle) * std::sin(turn));
        EXPECT_NEAR(outline.along(point), share * outline.length(), 0.005 * outline.length());
      }
    }
  }
  EXPECT_EQ(outline.along({0, -0.05, 0}), 0);
  EXPECT_NEAR(outline.along({0, 0.05, 0}), outline.length(), 1e-12);
}

/// The spiral follows the convex hull where the skin is hollow: the hull of a torus has flat ends.
TEST(OutlinePlace, BridgesHollows) {
  const DiffusionSurfaces ring = shapes::torus(0.04, 0.01, 96, 48);
  const OutlinePlace outline{SkinDepth(ring).skin()};
  EXPECT_NEAR(outline.length(), 2 * 0.04 + pi * 0.01, 1e-3 * outline.length());
}

/// Once around the axis towards -Z the ridge is a pitch farther along.
TEST(TurnsFromRidge, AreNoneOnAHelix) {
  const double pitch = 0.015;
  for (double turn = -0.49; turn < 0.5; turn += 0.07) {
    const glm::dvec3 point(std::cos(2 * pi * turn), 0.3, -std::sin(2 * pi * turn));
    for (const int whole : {0, 1, 5}) {
      EXPECT_NEAR(turns_from_ridge((turn + whole) * pitch, point, pitch), 0, 1e-12);
      EXPECT_NEAR(turns_from_ridge((turn + whole + 0.3) * pitch, point, pitch), 0.3, 1e-12);
      EXPECT_NEAR(turns_from_ridge((turn + whole + 0.7) * pitch, point, pitch), -0.3, 1e-12);
    }
  }
}

/// The offset of a ball is a ball; of a torus, a torus with a thinner tube.
TEST(Peeled, LeavesAClosedSurfaceOfTheRightVolume) {
  const ClosedSurface inner = peeled(ball(0.03, 48), {.thickness = 0.004});
  EXPECT_TRUE(is_closed(inner));
  EXPECT_GT(thinnest_of(inner), 0.1);
  const double ball_volume = 4. / 3 * pi * std::pow(0.026, 3);
  EXPECT_NEAR(volume_of(inner), ball_volume, 0.005 * ball_volume);

  const ClosedSurface tube = peeled(shapes::torus(0.04, 0.015, 128, 64), {.thickness = 0.005});
  EXPECT_TRUE(is_closed(tube));
  const double torus_volume = 2 * pi * pi * 0.04 * 0.01 * 0.01;
  EXPECT_NEAR(volume_of(tube), torus_volume, 0.01 * torus_volume);
}

TEST(Peeled, InAStripIsClosedAndTakesLessThanInOne) {
  const DiffusionSurfaces fruit = ball(0.03);
  const ClosedSurface whole = peeled(fruit, {.thickness = 0.002});
  const ClosedSurface ridged = peeled(fruit, {.thickness = 0.002, .strip = 0.02});
  EXPECT_TRUE(is_closed(ridged));
  EXPECT_GT(volume_of(ridged), volume_of(whole)) << "the ridge stays";
}

/// Around the hole of a ring two turns of the ridge would touch, so the ridge ends there; the rest of it remains.
TEST(Peeled, InAStripIsClosedWhereTheRidgeWouldTouchItself) {
  const DiffusionSurfaces ring = shapes::torus(0.025, 0.012, 32, 16);
  const ClosedSurface ridged = peeled(ring, {.thickness = 0.002, .strip = 0.012});
  EXPECT_TRUE(is_closed(ridged));
  EXPECT_GT(volume_of(ridged), volume_of(peeled(ring, {.thickness = 0.002}))) << "the ridge stays";
}

}  // namespace
}  // namespace pomona
