// The reference against exact integrals [notes on positive mean values: linear precision, shell, P2, plates].
#include "generator/diffusion/pmvc/cube_pmvc.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/units.h"
#include "generator/diffusion/pmvc/cube_directions.h"
#include "tests/diffusion/brute_force_pmvc.h"
#include "tests/diffusion/fields.h"
#include "tests/shapes/seeded_fruit.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

std::vector<PmvcValue> values(const DiffusionSurfaces& surfaces, const std::vector<glm::vec3>& points,
                              int texels = 64) {
  return cube_pmvc(surfaces, make_surface_tree(surfaces), points, texels);
}

double value_at(const DiffusionSurfaces& surfaces, const glm::vec3& point, int texels = 64) {
  return values(surfaces, {point}, texels).front().color.x;
}

double greatest(const glm::dvec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

TEST(CubeDirections, SolidAnglesFillTheSphere) {
  for (const int texels : {1, 8, 64}) {
    double sum = 0;
    for (const double angle : make_cube_face(texels).solid_angle) sum += 6 * angle;
    EXPECT_NEAR(sum, 4 * pi, 1e-12) << texels;
  }
}

TEST(CubeDirections, MirrorImagesHaveTheSameBits) {
  const CubeFace face = make_cube_face(16);
  for (std::size_t y = 0; y < 16; ++y) {
    for (std::size_t x = 0; x < 16; ++x) {
      EXPECT_EQ(face.solid_angle[16 * y + x], face.solid_angle[16 * (15 - y) + (15 - x)]);
      EXPECT_EQ(face.middle[x], -face.middle[15 - x]);
    }
  }
}

TEST(CubePmvc, ReproducesLinearFieldsInAClosedSceneWithOccluders) {
  const DiffusionSurfaces scene = fields::linear_scene();
  const std::vector<glm::vec3> points = fields::points_in_linear_scene();
  for (const int texels : {8, 64}) {
    const std::vector<PmvcValue> found = values(scene, points, texels);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_LE(greatest(found[i].color - fields::dyadic_linear(glm::dvec3(points[i]))), 1e-12) << texels << " " << i;
    }
  }
}

/// Inner sphere 1, outer sphere 0.
DiffusionSurfaces shell(int n) {
  shapes::Paint inner, outer;
  inner.front = inner.back = Color(1);
  outer.front = outer.back = Color(0);
  return joined(shapes::sphere(0.4, n, inner), shapes::sphere(1, n, outer));
}

TEST(CubePmvc, ShellHasTheValuesOfItsExactIntegral) {
  const DiffusionSurfaces spheres = shell(48);
  EXPECT_NEAR(value_at(spheres, {0, 0.5f, 0}), 0.576000, 1e-3);
  EXPECT_NEAR(value_at(spheres, {0, 0.7f, 0}), 0.136582, 1e-3);
  EXPECT_NEAR(value_at(spheres, {0.9f, 0, 0}), 0.025501, 1e-3);
  EXPECT_NEAR(value_at(spheres, {0.4041f, 0.4041f, 0.4041f}), 0.136582, 1e-3);
}

TEST(CubePmvc, KnownMistakesWouldBeNoticed) {
  const DiffusionSurfaces spheres = shell(8);
  const glm::dvec3 point(0, 0.7, 0);
  const double right = value_at(spheres, glm::vec3(point), 16);
  EXPECT_NEAR(brute_force_pmvc(spheres, point, 16).color.x, right, 1e-6);
  EXPECT_NEAR(brute_force_pmvc(spheres, point, 16, Mistake::uniform_solid_angle).color.x, 0.097, 0.01);
  EXPECT_NEAR(brute_force_pmvc(spheres, point, 16, Mistake::planar_distance).color.x, 0.124, 0.01);
  EXPECT_NEAR(brute_force_pmvc(spheres, point, 16, Mistake::both).color.x, 0.085, 0.01);
  for (const Mistake mistake : {Mistake::uniform_solid_angle, Mistake::planar_distance, Mistake::both}) {
    EXPECT_GT(std::fabs(brute_force_pmvc(spheres, point, 16, mistake).color.x - right), 0.009);
  }
}

TEST(CubePmvc, SecondLegendrePolynomialOnTheUnitSphere) {
  const DiffusionSurfaces sphere = fields::painted_with(shapes::sphere(1, 48), [](const glm::dvec3& p) {
    const double cosine = p.y / glm::length(p);
    return glm::dvec3(0.5 * (3 * cosine * cosine - 1));
  });
  EXPECT_NEAR(value_at(sphere, {0, 0.25f, 0}), 0.0666, 1e-3);
  EXPECT_NEAR(value_at(sphere, {0, 0.50f, 0}), 0.2648, 1e-3);
  EXPECT_NEAR(value_at(sphere, {0, 0.75f, 0}), 0.5883, 1e-3);
}

TEST(CubePmvc, IsLinearBetweenParallelPlates) {
  shapes::Paint lower, upper;
  lower.front = lower.back = Color(1);
  upper.front = upper.back = Color(0);
  const DiffusionSurfaces plates = shapes::two_plates(200, 1, lower, upper);
  for (const float h : {0.1f, 0.25f, 0.5f, 0.9f}) {
    EXPECT_NEAR(value_at(plates, {0.3f, h - 0.5f, 0.2f}, 128), 1 - static_cast<double>(h), 2e-3) << h;
  }
}

TEST(CubePmvc, AgreesWithBruteForce) {
  const DiffusionSurfaces scene =
      shapes::tilted(joined(joined(shell(3), shapes::torus(0.6, 0.1, 12, 8)), shapes::open_sheet(0.9, 0.5, 2)));
  const std::vector<glm::vec3> points{{0.5f, 0.1f, 0.2f}, {-0.6f, 0.3f, 0.35f}, {0, 0.1f, 0}, {2, 1, 0.5f}};
  const std::vector<PmvcValue> found = values(scene, points, 16);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PmvcValue expected = brute_force_pmvc(scene, glm::dvec3(points[i]), 16);
    EXPECT_LE(greatest(found[i].color - expected.color), 1e-9) << i;
    EXPECT_NEAR(found[i].weight, expected.weight, 1e-9 * expected.weight) << i;
    EXPECT_EQ(found[i].part, expected.part) << i;
  }
}

/// Two boxes in one place, seen from their middle: all depths are exactly 1, however the boxes are divided.
TEST(CubePmvc, EqualDepthsGoToTheSmallerTriangleIndex) {
  shapes::Paint first, second;
  first.front = first.back = Color(1);
  second.front = second.back = Color(0);
  for (const int n : {1, 2, 4}) {
    for (const int other : {1, 2, 4}) {
      const DiffusionSurfaces boxes =
          joined(shapes::box({-1, -1, -1}, {1, 1, 1}, n, first), shapes::box({-1, -1, -1}, {1, 1, 1}, other, second));
      for (const int texels : {8, 64}) EXPECT_EQ(value_at(boxes, {0, 0, 0}, texels), 1) << n << ' ' << other;
    }
  }
}

TEST(CubePmvc, QuarterTurnsChangeNothing) {
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  std::vector<glm::vec3> points = shapes::points_on_section_of_seeded_fruit(20);
  const auto turned = [](const glm::vec3& p) { return glm::vec3(p.z, p.y, -p.x); };
  DiffusionSurfaces turned_fruit = fruit;
  std::transform(fruit.position.begin(), fruit.position.end(), turned_fruit.position.begin(), turned);
  std::vector<glm::vec3> turned_points = points;
  std::transform(points.begin(), points.end(), turned_points.begin(), turned);

  const std::vector<PmvcValue> before = values(fruit, points), after = values(turned_fruit, turned_points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LE(greatest(before[i].color - after[i].color), 1e-12) << i;
    EXPECT_EQ(before[i].part, after[i].part) << i;
  }
}

TEST(CubePmvc, AnyTurnChangesLittleAt32Texels) {
  // The points become vertices without triangles, so that they are turned, too.
  DiffusionSurfaces fruit = shapes::seeded_fruit();
  const std::vector<glm::vec3> points = shapes::points_on_section_of_seeded_fruit(100);
  fruit.position.insert(fruit.position.end(), points.begin(), points.end());
  for (std::vector<Color>* colors : {&fruit.front_color, &fruit.back_color}) colors->resize(fruit.position.size());
  const DiffusionSurfaces turned = shapes::tilted(fruit);
  const std::vector<glm::vec3> turned_points(turned.position.end() - static_cast<std::ptrdiff_t>(points.size()),
                                             turned.position.end());

  const std::vector<PmvcValue> before = values(fruit, points, 32), after = values(turned, turned_points, 32);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LE(255 * greatest(before[i].color - after[i].color), 2) << i;
  }
}

TEST(CubePmvc, MoreDirectionsChangeLittle) {
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  const std::vector<glm::vec3> points = shapes::points_on_section_of_seeded_fruit(40);
  const std::vector<PmvcValue> usual = values(fruit, points, 64), more = values(fruit, points, 128);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_LE(255 * greatest(usual[i].color - more[i].color), 0.3) << i;
}

TEST(CubePmvc, NothingSeenWeighsNothing) {
  // A point in the plane of an open sheet, beside the sheet.
  const std::vector<PmvcValue> found = values(shapes::open_sheet(1, 0), {{2, 0, 0}}, 16);
  EXPECT_EQ(found.front().weight, 0);
}

}  // namespace
}  // namespace pomona
