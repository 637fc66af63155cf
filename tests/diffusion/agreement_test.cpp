// Three independent methods of true diffusion agree: walks on spheres, a grid, and tetrahedra.
#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "bench/baselines/tetrahedral_poisson.h"
#include "generator/diffusion/harmonic/harmonic_diffuser.h"
#include "generator/diffusion/walk/walk_on_spheres.h"
#include "tests/diffusion/fields.h"
#include "tests/shapes/seeded_fruit.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

shapes::Paint plain(float front, float back) { return {.front = Color(front), .back = Color(back)}; }

/// In parts of 255, over all points.
struct Allowed {
  double rms = 0, max = 0;
};

constexpr double standard_error = 0.7;

/// The limits that docs/reference/diffusion.md states for the grid; the walk's own error is added.
constexpr Allowed grid{.rms = 1, .max = 4};

class Agreement {
 public:
  Agreement(DiffusionSurfaces surfaces, std::vector<glm::vec3> points)
      : surfaces_(std::move(surfaces)),
        points_(std::move(points)),
        walked_(WalkOnSpheres(surfaces_, {.standard_error = standard_error}).at(points_)) {}

  /// Walks state their own error. In addition, only the error of a round shape's facets is allowed.
  void expect_walks_near(const std::function<glm::dvec3(const glm::dvec3&)>& truth, double facets = 0) const {
    double squares = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const glm::dvec3 error = 255.0 * (glm::dvec3(walked_.color[i]) - truth(glm::dvec3(points_[i])));
      squares += glm::dot(error, error) / 3 / static_cast<double>(points_.size());
      EXPECT_LT(std::sqrt(glm::dot(error, error) / 3), 5 * walked_.standard_error[i] + facets) << "point " << i;
    }
    EXPECT_LT(std::sqrt(squares), 1.3 * standard_error + facets);
  }

  void expect_grid(const Allowed& allowed) const {
    const DiffusedColors colors = make_harmonic_diffuser({.quality = Quality::final})->diffuse(surfaces_, points_);
    expect_near(colors.color, allowed, "grid");
  }

  void expect_tetrahedra(double cell_size, const Allowed& allowed) const {
    const bench::TetrahedralPoisson poisson(surfaces_, {.cell_size = cell_size});
    ASSERT_EQ(poisson.why_not(), "");
    expect_near(poisson.at(points_), allowed, "tetrahedra");
  }

  /// Tetrahedra of half the size have a third of the error (tetrahedral_poisson_test), so the error of the finer ones
  /// is less than the difference of both.
  void expect_tetrahedra(double cell_size) const {
    const bench::TetrahedralPoisson coarse(surfaces_, {.cell_size = 2 * cell_size});
    const bench::TetrahedralPoisson fine(surfaces_, {.cell_size = cell_size});
    ASSERT_EQ(fine.why_not(), "");
    const std::vector<Color> colors = fine.at(points_);
    const fields::Errors differences = fields::errors_of(coarse.at(points_), colors);
    expect_near(colors, {.rms = differences.rms, .max = differences.max}, "tetrahedra");
  }

 private:
  void expect_near(const std::vector<Color>& colors, const Allowed& allowed, const char* what) const {
    const fields::Errors errors = fields::errors_of(colors, walked_.color);
    EXPECT_LT(errors.rms, std::sqrt(allowed.rms * allowed.rms + standard_error * standard_error)) << what;
    EXPECT_LT(errors.max, allowed.max + 5 * standard_error) << what;
  }

  DiffusionSurfaces surfaces_;
  std::vector<glm::vec3> points_;
  WalkResult walked_;
};

/// Two dozen points on a spiral between two radii.
std::vector<glm::vec3> spiral(double inner, double outer) {
  std::vector<glm::vec3> points;
  constexpr int count = 24;
  for (int i = 0; i < count; ++i) {
    const double y = (i + 0.5) * 2 / count - 1, around = 2.4 * i, across = std::sqrt(1 - y * y);
    const double r = inner + (outer - inner) * (i * 7 % count) / count;
    points.emplace_back(r * glm::dvec3(across * std::cos(around), y, across * std::sin(around)));
  }
  return points;
}

TEST(Agreement, InAShell) {
  const Agreement shell(shapes::nested_spheres(1, 0.4, 24, plain(0, 0), plain(1, 1)), spiral(0.45, 0.95));
  shell.expect_walks_near([](const glm::dvec3& p) { return glm::dvec3((1 / glm::length(p) - 1) / 1.5); }, 0.3);
  shell.expect_grid(grid);
  // Linear tetrahedra of an eighth are wrong by 3.6 of 255 RMS and 9.2 at most; coarser ones take longer to mesh.
  shell.expect_tetrahedra(0.125 / std::sqrt(12.0), {.rms = 5, .max = 12});
}

TEST(Agreement, InATiltedBoxWithAnOpenSheet) {
  DiffusionSurfaces carrier;
  carrier.position = fields::points_in_linear_scene();
  // The field turns with the shape: its value at a turned point is that of the point before the turn.
  const std::vector<glm::vec3> straight = carrier.position, points = shapes::tilted(std::move(carrier)).position;
  const Agreement box(shapes::tilted(fields::linear_scene()), points);
  box.expect_walks_near([&](const glm::dvec3& p) {
    const auto at = std::find(points.begin(), points.end(), glm::vec3(p));
    return fields::dyadic_linear(glm::dvec3(straight[static_cast<std::size_t>(at - points.begin())]));
  });
  box.expect_grid({.rms = 0.1, .max = 0.3});
  box.expect_tetrahedra(0.3 / std::sqrt(12.0));
}

double around_ball(double radius, const glm::dvec3& p) { return (1 / glm::length(p) - 1) / (1 / radius - 1); }

TEST(Agreement, AroundASmallSphere) {
  constexpr double a = 0.1;
  const Agreement speck(shapes::nested_spheres(1, a, 12, plain(0, 0), plain(1, 1)), spiral(0.13, 0.9));
  speck.expect_walks_near([](const glm::dvec3& p) { return glm::dvec3(around_ball(a, p)); }, 0.6);
  speck.expect_grid(grid);
  speck.expect_tetrahedra(0.2 / std::sqrt(12.0));
}

TEST(Agreement, OnTheSectionOfASeededFruit) {
  // Its septa cross its chambers, so there are no tetrahedra.
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  std::vector<glm::vec3> points;
  const std::vector<glm::vec3> all = shapes::points_on_section_of_seeded_fruit(3000);
  for (std::size_t i = 0; i < all.size(); i += 60) points.push_back(all[i]);
  const Agreement section(fruit, points);
  section.expect_grid(grid);
}

}  // namespace
}  // namespace pomona
