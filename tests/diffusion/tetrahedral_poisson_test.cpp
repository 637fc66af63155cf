#include "bench/baselines/tetrahedral_poisson.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/diffusion/fields.h"
#include "tests/shapes/shapes.h"

namespace pomona::bench {
namespace {

shapes::Paint plain(float front, float back) { return {.front = Color(front), .back = Color(back)}; }

std::vector<glm::vec3> points_in_shell() {
  std::vector<glm::vec3> points;
  for (int i = 0; i < 400; ++i) {
    // A spiral from pole to pole, at radii from 0.45 to 0.95.
    const float y = (static_cast<float>(i) + 0.5f) / 200 - 1, around = 2.4f * static_cast<float>(i);
    const float r = std::sqrt(1 - y * y);
    points.push_back((0.45f + 0.5f * static_cast<float>(i * 7 % 400) / 400) *
                     glm::vec3(r * std::cos(around), y, r * std::sin(around)));
  }
  return points;
}

/// RMS against the harmonic function of a shell from 0.4 to 1.
double error_in_shell(const TetrahedralPoisson& poisson) {
  const std::vector<glm::vec3> points = points_in_shell();
  const std::vector<Color> colors = poisson.at(points);
  double squares = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double error = colors[i].x - (1 / glm::length(points[i]) - 1) / 1.5;
    squares += error * error / static_cast<double>(points.size());
  }
  return std::sqrt(squares);
}

TEST(TetrahedralPoisson, ErrorFallsByThreeWhenCellsAreHalved) {
  const DiffusionSurfaces shell = shapes::nested_spheres(1, 0.4, 24, plain(0, 0), plain(1, 1));
  const TetrahedralPoisson coarse(shell, {.cell_size = 0.32 / std::sqrt(12.0)});
  const TetrahedralPoisson fine(shell, {.cell_size = 0.16 / std::sqrt(12.0)});
  ASSERT_EQ(coarse.why_not(), "");
  ASSERT_EQ(fine.why_not(), "");
  const double error_of_coarse = error_in_shell(coarse), error_of_fine = error_in_shell(fine);
  EXPECT_LT(error_of_fine, 0.03);
  EXPECT_GT(error_of_coarse / error_of_fine, 3);
  EXPECT_LT(fine.cost().residual, 1e-9);
}

TEST(TetrahedralPoisson, KeepsBothSidesOfAnOpenSheet) {
  const DiffusionSurfaces scene = shapes::tilted(
      joined(shapes::box({-1, -1, -1}, {1, 1, 1}, 1, plain(0.5f, 0.5f)), shapes::open_sheet(1, 0, 1, plain(1, 0))));
  const TetrahedralPoisson poisson(scene, {.cell_size = 0.2 / std::sqrt(12.0)});
  ASSERT_EQ(poisson.why_not(), "");
  EXPECT_LT(poisson.cost().overshoot, 1e-3);
  EXPECT_LT(poisson.cost().residual, 1e-9);

  DiffusionSurfaces carrier;
  carrier.position = {{0.1f, 1e-4f, 0.1f}, {0.1f, -1e-4f, 0.1f}, {0.1f, 0.3f, 0.2f}, {0.1f, -0.3f, 0.2f}};
  const std::vector<Color> colors = poisson.at(shapes::tilted(carrier).position);
  EXPECT_NEAR(colors[0].x, 1, 2e-3);
  EXPECT_NEAR(colors[1].x, 0, 2e-3);
  EXPECT_NEAR(colors[2].x + colors[3].x, 1, 0.02);
}

TEST(TetrahedralPoisson, KeepsLinearFields) {
  const DiffusionSurfaces scene = fields::linear_scene();
  const TetrahedralPoisson poisson(scene, {.cell_size = 0.3 / std::sqrt(12.0)});
  ASSERT_EQ(poisson.why_not(), "");
  const std::vector<glm::vec3> points = fields::points_in_linear_scene();
  const std::vector<Color> colors = poisson.at(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LT(glm::length(glm::dvec3(colors[i]) - fields::dyadic_linear(glm::dvec3(points[i]))), 1e-5);
  }
}

TEST(TetrahedralPoisson, SaysWhyNot) {
  const DiffusionSurfaces ball = shapes::sphere(1, 4);
  DiffusionSurfaces across = shapes::open_sheet(1, 0.6, 2);
  across = shapes::moved(across, {0.5, 0, 0});
  across.surface_names = {"leaf"};
  const TetrahedralPoisson crossing(joined(ball, across), {});
  EXPECT_NE(crossing.why_not().find("cross or touch each other: surface and leaf"), std::string::npos)
      << crossing.why_not();
  EXPECT_EQ(TetrahedralPoisson(shapes::open_sheet(1, 0, 2), {}).why_not(), "the outermost surface is open");
  const DiffusionSurfaces apart = joined(ball, shapes::moved(shapes::sphere(0.5, 4), {3, 0, 0}));
  EXPECT_EQ(TetrahedralPoisson(apart, {}).why_not(), "no surface holds all others");
}

}  // namespace
}  // namespace pomona::bench
