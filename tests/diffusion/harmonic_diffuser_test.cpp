#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/random.h"
#include "generator/diffusion/harmonic/harmonic_diffuser.h"
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
  const auto points = points_in_shell(0.41, 0.99, 2000);
  std::vector<Color> truth;
  for (const glm::vec3& p : points) truth.emplace_back(static_cast<float>((1 / glm::length(glm::dvec3(p)) - 1) / 1.5));
  const auto colors = make_harmonic_diffuser({.threads = {2}, .nodes = nodes, .cycles = 4})->diffuse(shell(), points);
  return fields::errors_of(colors.color, truth);
}

TEST(HarmonicDiffuser, SolvesTheShellToSecondOrder) {
  // Cells of 2 / 28 to 2 / 92, as in the measurements that set these limits.
  const fields::Errors coarse = shell_errors(28), fine = shell_errors(60), finest = shell_errors(92);
  EXPECT_LT(coarse.rms, 0.40);
  EXPECT_LT(fine.rms, 0.11);
  EXPECT_LT(finest.rms, 0.065);
  EXPECT_LT(coarse.max, 3.0);
  EXPECT_LT(fine.max, 0.9);
  EXPECT_LT(finest.max, 0.45);
  EXPECT_GT(coarse.rms / fine.rms, 3.4);
}

TEST(HarmonicDiffuser, IsExactForLinearColours) {
  const auto paint = [](const glm::dvec3& p) {
    return 0.5 + glm::dvec3(0.1 * p.x, 0.1 * p.y - 0.05 * p.x, 0.08 * p.z);
  };
  const DiffusionSurfaces linear = fields::painted_with(shapes::tilted(fields::linear_scene()), paint);
  const auto points = points_in_shell(0, 0.95, 1000);
  const auto colors = make_harmonic_diffuser({.threads = {2}, .nodes = 64, .cycles = 8})->diffuse(linear, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec3 wanted = paint(points[i]);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(colors.color[i][k], wanted[k], 0.01 / 255) << i;
  }
}

/// The strength of a white ball of radius `radius` around `place` in a black unit sphere, relative to the exact one.
double strength_of_ball(double radius, const glm::dvec3& place, const HarmonicOptions& options) {
  shapes::Paint white = evenly(1);
  const DiffusionSurfaces scene =
      joined(shapes::sphere(1, 24, evenly(0)), shapes::moved(shapes::sphere(radius, 12, white), place));
  double found = 0, right = 0;
  std::vector<glm::vec3> points;
  for (const glm::vec3& p : points_in_shell(0.15, 0.3, 300)) points.push_back(p + glm::vec3(place));
  const auto colors = make_harmonic_diffuser(options)->diffuse(scene, points).color;
  for (std::size_t i = 0; i < points.size(); ++i) {
    found += colors[i].r;
    right += (1 / glm::length(glm::dvec3(points[i]) - place) - 1) / (1 / radius - 1);
  }
  return found / right;
}

TEST(HarmonicDiffuser, SeesSeedsSmallerThanItsCells) {
  const RandomStream random({}, "tests/small seeds");
  constexpr int nodes = 32;
  for (const double cells : {1.8, 0.9, 0.45}) {
    for (std::uint64_t n = 0; n < 12; n += 3) {
      const glm::dvec3 place = 0.02 * glm::dvec3(random.uniform(n), random.uniform(n + 1), random.uniform(n + 2));
      const double strength = strength_of_ball(cells * 2 / nodes, place, {.threads = {2}, .nodes = nodes, .cycles = 3});
      EXPECT_NEAR(strength, 1, 0.08) << cells << " cells, " << n;
    }
  }
}

TEST(HarmonicDiffuser, LetsNoSeedPop) {
  constexpr int nodes = 32;
  constexpr double cell = 2.0 / nodes;
  // The smallest still has 1.2 cells of the finest patch to its radius.
  for (const auto& [cells, limit] : {std::pair{1.2, 0.1}, {0.5, 0.1}, {0.3, 0.15}}) {
    double min = 10, greatest = 0;
    for (int step = 0; step <= 6; ++step) {
      const glm::dvec3 place = cell * step / 6 * glm::dvec3(1, 0.7, 0.4);
      const double strength = strength_of_ball(cells * cell, place, {.threads = {2}, .nodes = nodes});
      min = std::min(min, strength);
      greatest = std::max(greatest, strength);
    }
    EXPECT_GT(min, 0.85) << cells;
    EXPECT_LT(greatest, 1 + limit) << cells;
    EXPECT_LT(greatest - min, limit) << cells;
  }
}

TEST(HarmonicDiffuser, NeverLeaks) {
  // White inside, black outside, so that a leak shows. The box's faces lie on nodes at shift 0.
  shapes::Paint paint = evenly(1);
  paint.front = Color(0);
  const std::vector<DiffusionSurfaces> scenes = {
      shapes::sphere(0.9, 16, paint), shapes::box(glm::dvec3(-1), glm::dvec3(1), 2, paint),
      shapes::tilted(shapes::box(glm::dvec3(-0.5), glm::dvec3(0.5), 3, paint))};
  const RandomStream random({}, "tests/grid offsets");
  const auto points = points_in_shell(0, 0.45, 100);
  for (int i = 0; i <= 30; ++i) {
    HarmonicOptions options{.threads = {2}, .nodes = 16 + i};
    const auto n = static_cast<std::uint64_t>(3 * i);
    if (i > 0) options.shift = {random.uniform(n), random.uniform(n + 1), random.uniform(n + 2)};
    for (std::size_t scene = 0; scene < scenes.size(); ++scene) {
      for (const Color& color : make_harmonic_diffuser(options)->diffuse(scenes[scene], points).color) {
        ASSERT_NEAR(color.r, 1, 1e-6) << "scene " << scene << ", offset " << i;
      }
    }
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

TEST(HarmonicDiffuser, CountsEscapedWalksAsMisses) {
  // An open sheet of one colour gives that colour everywhere. Two sides of different colours give each its colour
  // nearby, and their mean far away in the sheet's plane.
  const DiffusionSurfaces plain = shapes::tilted(shapes::open_sheet(1, 0, 4, evenly(0.7f)));
  for (const Color& color :
       make_harmonic_diffuser({.threads = {2}, .nodes = 24})->diffuse(plain, points_in_shell(0, 2, 200)).color) {
    EXPECT_NEAR(color.r, 0.7, 1e-5);
  }
  shapes::Paint paint;
  paint.front = Color(1);
  paint.back = Color(0);
  const DiffusionSurfaces two_sided = shapes::open_sheet(1, 0, 4, paint);
  const std::vector<glm::vec3> points = {{0, 0.02f, 0}, {0, -0.02f, 0}, {0.62f, 0, 0.1f}};
  for (const double shift : {0.0, 0.5}) {
    const HarmonicOptions options{.threads = {2}, .nodes = 48, .cycles = 4, .shift = {0, shift, 0}};
    const auto colors = make_harmonic_diffuser(options)->diffuse(two_sided, points).color;
    EXPECT_GT(colors[0].r, 0.9);
    EXPECT_LT(colors[1].r, 0.1);
    // Nodes on the sheet belong to its front. This causes an error beyond a free rim, where the field is like a square
    // root.
    EXPECT_NEAR(colors[2].r, 0.5, shift == 0 ? 0.1 : 0.03);
  }
}

TEST(HarmonicDiffuser, AnswersOnNextToAndBeyondSurfaces) {
  shapes::Paint paint;
  paint.front = Color(1, 0, 0);
  paint.back = Color(0, 1, 0);
  paint.front_part = "outside";
  paint.back_part = "inside";
  const DiffusionSurfaces box = shapes::box(glm::dvec3(-1), glm::dvec3(1), 4, paint);
  const auto field = make_harmonic_diffuser({.threads = {2}, .nodes = 20})->field(box);
  const std::vector<glm::vec3> inside = {{0, 0, 0}, {0.999f, 0, 0}, {0.999f, 0.999f, 0.999f}, {-0.5f, 0.99999f, 0.3f}};
  const std::vector<glm::vec3> outside = {{1.001f, 0, 0}, {3, 4, 5}, {1e6f, 0, 0}, {-1.01f, -1.01f, 1.01f}};
  for (const Color& color : field->at(inside).color) EXPECT_NEAR(color.g, 1, 1e-6);
  for (const Color& color : field->at(outside).color) EXPECT_NEAR(color.r, 1, 1e-6);
  EXPECT_EQ(box.part_names[static_cast<std::size_t>(field->at(inside).part.front())], "inside");
  EXPECT_EQ(box.part_names[static_cast<std::size_t>(field->at(outside).part.front())], "outside");
  EXPECT_TRUE(field->at({}).color.empty());
  EXPECT_THROW(field->at(std::vector<glm::vec3>{{0, NAN, 0}}), Error);
}

TEST(HarmonicDiffuser, StaysWithinTheHullOfColours) {
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  Color low(1), high(0);
  for (const auto* side : {&fruit.front_color, &fruit.back_color}) {
    for (const Color& color : *side) {
      low = glm::min(low, color);
      high = glm::max(high, color);
    }
  }
  std::vector<glm::vec3> points;
  for (const glm::vec3& p : points_in_shell(0, 1.2, 3000)) points.push_back(0.04f * p);
  for (const Color& color : make_harmonic_diffuser({.threads = {2}, .nodes = 40})->diffuse(fruit, points).color) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(color[k], low[k]);
      EXPECT_LE(color[k], high[k]);
    }
  }
}

TEST(HarmonicDiffuser, RefusesOrIgnoresWhatIsNoSurface) {
  EXPECT_THROW(make_harmonic_diffuser()->field({}), Error);
  DiffusionSurfaces ball = shapes::sphere(1, 6, evenly(0.5f));
  DiffusionSurfaces lines = ball;
  for (glm::uvec3& t : lines.triangle) t.z = t.y;
  EXPECT_THROW(make_harmonic_diffuser()->field(lines), Error);
  DiffusionSurfaces broken = ball;
  broken.position[3].y = NAN;
  EXPECT_THROW(make_harmonic_diffuser()->field(broken), Error);

  // Neither degenerate triangles nor a flat model do any harm.
  ball.triangle[0].y = ball.triangle[0].x;
  const auto points = points_in_shell(0, 0.5, 20);
  for (const Color& c : make_harmonic_diffuser({.threads = {2}, .nodes = 12})->diffuse(ball, points).color)
    EXPECT_NEAR(c.r, 0.5, 1e-5);
  const DiffusionSurfaces flat = shapes::open_sheet(1, 0, 1, evenly(0.25f));
  for (const Color& c : make_harmonic_diffuser({.threads = {2}, .nodes = 12})->diffuse(flat, points).color)
    EXPECT_NEAR(c.r, 0.25, 1e-5);
}

TEST(HarmonicDiffuser, TakesTenTrianglesAMillionAndAMillionTexels) {
  DiffusionSurfaces few = shapes::sphere(1, 2, evenly(0.5f));
  few.triangle.resize(10);
  few.surface.resize(10);
  few.front_part.resize(10);
  few.back_part.resize(10);
  std::vector<glm::vec3> texels;
  for (int y = 0; y < 1000; ++y) {
    for (int x = 0; x < 1000; ++x) texels.emplace_back(0.0012 * x - 0.6, 0.1, 0.0012 * y - 0.6);
  }
  for (const Color& color : make_harmonic_diffuser({.threads = {2}, .nodes = 24})->diffuse(few, texels).color) {
    ASSERT_NEAR(color.r, 0.5, 1e-4);
  }
  const DiffusionSurfaces many = shapes::sphere(1, 354, evenly(0.5f));
  ASSERT_GT(many.triangle_count(), 1'000'000u);
  for (const Color& color :
       make_harmonic_diffuser({.threads = {2}, .nodes = 24})->diffuse(many, points_in_shell(0, 0.99, 100)).color) {
    EXPECT_NEAR(color.r, 0.5, 1e-5);
  }
}

}  // namespace
}  // namespace pomona
