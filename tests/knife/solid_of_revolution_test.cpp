// Solids of revolution, against the formulas of the solids that they approximate.
#include "generator/knife/solid_of_revolution.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/units.h"
#include "tests/knife/closed_surface_checks.h"

namespace pomona {
namespace {

Curve circle(const glm::dvec2& middle, double radius, int corners) {
  Curve curve;
  curve.closed = true;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi * i / corners;
    curve.points.push_back(middle + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  return curve;
}

/// The number of vertices at this distance from the axis, at one height.
double count_in_ring(const ClosedSurface& surface, double radius, double height) {
  return static_cast<double>(std::count_if(surface.point.begin(), surface.point.end(), [&](const glm::dvec3& p) {
    return std::fabs(std::hypot(p.x, p.z) - radius) < 1e-12 && std::fabs(p.y - height) < 1e-12;
  }));
}

/// All its rings have equally many corners, so it is a prism, up to rounding.
TEST(SolidOfRevolution, OfAnUprightLineIsAPrism) {
  for (const double tolerance : {1e-3, 1e-4, 1e-5}) {
    const Curve side{{{0.02, -0.01}, {0.02, 0.05}}, false};
    const ClosedSurface prism = revolved(side, {.tolerance = tolerance});
    const double n = count_in_ring(prism, 0.02, -0.01);
    EXPECT_TRUE(is_closed(prism));
    EXPECT_EQ(count_in_ring(prism, 0.02, 0.05), n);
    EXPECT_LE(0.02 * (1 - std::cos(pi / n)), tolerance) << "how far a chord strays from its circle";
    EXPECT_NEAR(volume_of(prism), 0.5 * n * std::sin(2 * pi / n) * 0.02 * 0.02 * 0.06, 1e-16);
  }
}

/// The solid is inscribed, so it is never larger; the difference depends on the tolerance.
TEST(SolidOfRevolution, OfHalfACircleIsABall) {
  const double exact = 4. / 3 * pi * std::pow(0.03, 3);
  double last = exact;
  for (const double tolerance : {4e-4, 1e-4, 2.5e-5}) {
    const ClosedSurface ball = revolved(half_circle(0.03, tolerance), {.tolerance = tolerance});
    EXPECT_TRUE(is_closed(ball));
    EXPECT_GT(thinnest_of(ball), 0.1);
    const double missing = exact - volume_of(ball);
    EXPECT_GT(missing, 0);
    EXPECT_LT(missing, 2 * tolerance * area_of(ball));
    EXPECT_LT(missing, 0.5 * last);
    last = missing;
    for (const glm::dvec3& p : ball.point) EXPECT_NEAR(glm::length(p), 0.03, 2 * tolerance);
  }
}

/// [Pappus]: the area of a circle times the path length of its middle.
TEST(SolidOfRevolution, OfACircleBesideTheAxisIsATorus) {
  const double exact = 2 * pi * pi * 0.04 * 0.01 * 0.01;
  const ClosedSurface torus = revolved(circle({0.04, 0.02}, 0.01, 128), {.tolerance = 1e-6});
  EXPECT_TRUE(is_closed(torus));
  EXPECT_NEAR(volume_of(torus), exact, 1e-3 * exact);
  EXPECT_NEAR(area_of(torus), 4 * pi * pi * 0.04 * 0.01, 1e-3 * area_of(torus));

  // Drawn the other way round it is the same.
  Curve clockwise = circle({0.04, 0.02}, 0.01, 128);
  std::reverse(clockwise.points.begin(), clockwise.points.end());
  EXPECT_NEAR(volume_of(revolved(clockwise, {.tolerance = 1e-6})), volume_of(torus), 1e-9 * exact);
}

TEST(SolidOfRevolution, HasATipWhereItsProfileEndsOnTheAxis) {
  const Curve slope{{{0.03, 0}, {0, 0.04}}, false};
  const ClosedSurface cone = revolved(slope, {.tolerance = 1e-6});
  EXPECT_TRUE(is_closed(cone));
  EXPECT_NEAR(volume_of(cone), pi * 0.03 * 0.03 * 0.04 / 3, 1e-3 * volume_of(cone));
  EXPECT_EQ(count_in_ring(cone, 0, 0.04), 1);
}

TEST(SolidOfRevolution, OfTooManyTrianglesIsRefused) {
  const Curve wire{{{1e-4, 0}, {1e-4, 100}}, false};
  EXPECT_THROW(revolved(wire, {.tolerance = 1e-9}), Error);
}

/// Moved and turned: volumes stay, and the axis is where it should be.
TEST(SolidOfRevolution, GoesWhereItsPoseSays) {
  const ClosedSurface ball = revolved(half_circle(0.01, 1e-5));
  SolidPose pose;
  pose.at = {1, 2, 3};
  pose.axis = glm::normalize(glm::dvec3(1, 2, -2));
  pose.up = glm::cross(pose.axis, level_beside(pose.axis));
  const ClosedSurface moved = posed(ball, pose);
  double high = 0;
  for (const glm::dvec3& p : moved.point) {
    EXPECT_LT(glm::distance(p, pose.at), 0.01 + 1e-12);
    high = std::max(high, glm::dot(p - pose.at, pose.axis));
  }
  EXPECT_NEAR(high, 0.01, 1e-12) << "the pole lies along the axis";
  EXPECT_NEAR(volume_of(moved), volume_of(ball), 1e-12);

  for (const glm::dvec3& way : {pose.axis, glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1)}) {
    EXPECT_NEAR(glm::length(level_beside(way)), 1, 1e-15);
    EXPECT_NEAR(glm::dot(level_beside(way), way), 0, 1e-15);
    EXPECT_EQ(level_beside(way).y, 0);
  }
}

}  // namespace
}  // namespace pomona
