#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/random.h"
#include "generator/diffusion/harmonic_diffuser.h"
#include "tests/diffusion/fields.h"
#include "tests/shapes/seeded_fruit.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

shapes::Paint evenly(float shade) {
  shapes::Paint paint;
  paint.front = paint.back = Color(shade);
  return paint;
}

/// White core of radius 0.4 in a black skin of radius 1; 1 / r in between.
DiffusionSurfaces shell() { return shapes::nested_spheres(1, 0.4, 96, evenly(0), evenly(1)); }

std::vector<glm::vec3> points_in_shell(double low, double high, int count) {
  const RandomStream random({}, "tests/points in a shell");
  std::vector<glm::vec3> points;
  for (std::uint64_t n = 0; static_cast<int>(points.size()) < count; n += 3) {
    const glm::dvec3 p(2 * random.uniform(n) - 1, 2 * random.uniform(n + 1) - 1, 2 * random.uniform(n + 2) - 1);
    if (glm::length(p) > low && glm::length(p) < high) points.emplace_back(p);
  }
  return points;
}

fields::Errors shell_errors(int nodes) {
  const auto points = points_in_shell(0.41, 0.99, 4000);
  std::vector<Color> truth;
  for (const glm::vec3& p : points) truth.emplace_back(static_cast<float>((1 / glm::length(glm::dvec3(p)) - 1) / 1.5));
  const auto colors =
      make_harmonic_diffuser({.threads = {2}, .nodes = nodes, .cycles = 4})->diffuse(shell(), points).color;
  return fields::errors_of(colors, truth);
}

TEST(HarmonicDiffuser, SolvesTheShellToSecondOrder) {
  const fields::Errors coarse = shell_errors(32), middle = shell_errors(64), fine = shell_errors(96);
  EXPECT_LT(coarse.rms, 0.40);
  EXPECT_LT(middle.rms, 0.11);
  EXPECT_LT(fine.rms, 0.07);
  EXPECT_LT(coarse.max, 3.0);
  EXPECT_LT(middle.max, 0.9);
  EXPECT_GT(coarse.rms / middle.rms, 3.0);
}

TEST(HarmonicDiffuser, IsExactForLinearColours) {
  const DiffusionSurfaces scene = shapes::tilted(fields::linear_scene());
  const auto paint = [](const glm::dvec3& p) {
    return 0.5 + glm::dvec3(0.1 * p.x, 0.1 * p.y - 0.05 * p.x, 0.08 * p.z);
  };
  const DiffusionSurfaces linear = fields::painted_with(scene, paint);
  std::vector<glm::vec3> points;
  for (const glm::vec3& p : points_in_shell(0, 0.95, 1000)) points.push_back(p);
  const auto colors = make_harmonic_diffuser({.threads = {2}, .nodes = 48, .cycles = 8})->diffuse(linear, points).color;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec3 wanted = paint(points[i]);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(colors[i][k], wanted[k], 1e-4) << i;
  }
}

TEST(HarmonicDiffuser, DoesNotDependOnThreads) {
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  const auto points = shapes::points_on_section_of_seeded_fruit(1000);
  const auto alone = make_harmonic_diffuser({.quality = Quality::draft, .threads = {1}})->diffuse(fruit, points);
  for (const int count : {2, 5}) {
    const auto together =
        make_harmonic_diffuser({.quality = Quality::draft, .threads = {count}})->diffuse(fruit, points);
    EXPECT_EQ(alone.color, together.color);
    EXPECT_EQ(alone.part, together.part);
  }
}

}  // namespace
}  // namespace pomona
