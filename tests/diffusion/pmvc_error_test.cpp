// Draft and final keep the errors that they state, also against the exact values that the reference is tested with.
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "generator/diffusion/pmvc/line_directions.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/diffusion/pmvc/relaxed_lines.h"
#include "tests/diffusion/fields.h"
#include "tests/shapes/seeded_fruit.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

std::vector<Color> diffused(Quality quality, const DiffusionSurfaces& surfaces, const std::vector<glm::vec3>& points) {
  return make_pmvc_diffuser({quality, {}})->diffuse(surfaces, points).color;
}

TEST(LineDirections, AreUnitFramesSpreadEvenly) {
  const std::vector<Line> lines = line_directions(128);
  glm::dmat3 moment(0);
  for (const Line& line : lines) {
    EXPECT_NEAR(glm::length(line.along), 1, 1e-6);
    EXPECT_LE(glm::length(glm::cross(line.across_u, line.across_v) - line.along), 1e-6f);
    const glm::dvec3 d(line.along);
    moment += glm::outerProduct(d, d) / 128.0;
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(moment[i][j], i == j ? 1.0 / 3 : 0, 3e-3);
  }
}

TEST(RelaxedLines, AreUnitFramesInPairsThatKeepApart) {
  for (const std::vector<Line>& lines : {relaxed_draft_lines(), relaxed_final_lines()}) {
    // Each line stands for two caps of equal area; a hexagonal pattern would set them 1.9 / sqrt(count) apart.
    const double spacing = 1.9 / std::sqrt(static_cast<double>(lines.size()));
    double within_pairs = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      EXPECT_LE(glm::length(glm::cross(lines[i].across_u, lines[i].across_v) - lines[i].along), 1e-6f);
      for (std::size_t j = 0; j < i; ++j) {
        const double cosine = std::fabs(static_cast<double>(glm::dot(lines[i].along, lines[j].along)));
        EXPECT_GE(std::acos(std::min(cosine, 1.0)), 0.8 * spacing) << i << " " << j;
        if (i % 2 == 1 && j == i - 1) within_pairs += std::acos(cosine);
      }
    }
    EXPECT_LE(within_pairs / (static_cast<double>(lines.size()) / 2), 1.6 * spacing);
  }
}

TEST(PmvcError, IsWhatDraftAndFinalPromise) {
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  const std::vector<glm::vec3> points = shapes::points_on_section_of_seeded_fruit(600);
  const std::vector<Color> truth = diffused(Quality::reference, fruit, points);
  EXPECT_LE(fields::errors_of(diffused(Quality::draft, fruit, points), truth).rms, 1);
  const fields::Errors final_errors = fields::errors_of(diffused(Quality::final, fruit, points), truth);
  EXPECT_LE(final_errors.rms, 0.4);
  EXPECT_LE(final_errors.p95, 1);
  EXPECT_LE(final_errors.max, 2);
}

TEST(PmvcError, TurningTheSceneStaysWithinIt) {
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  std::vector<glm::vec3> points = shapes::points_on_section_of_seeded_fruit(600);
  DiffusionSurfaces with_points = fruit;
  with_points.position.insert(with_points.position.end(), points.begin(), points.end());
  const DiffusionSurfaces turned = shapes::tilted(with_points);
  const std::vector<glm::vec3> turned_points(turned.position.end() - static_cast<std::ptrdiff_t>(points.size()),
                                             turned.position.end());
  DiffusionSurfaces turned_fruit = fruit;
  turned_fruit.position.assign(turned.position.begin(),
                               turned.position.end() - static_cast<std::ptrdiff_t>(points.size()));

  // The error bound holds for any orientation: the turned scene is compared with the values of the original one.
  const std::vector<Color> truth = diffused(Quality::reference, fruit, points);
  const std::vector<Color> draft = diffused(Quality::draft, turned_fruit, turned_points);
  const std::vector<Color> fine = diffused(Quality::final, turned_fruit, turned_points);
  EXPECT_LE(fields::errors_of(draft, truth).rms, 1);
  EXPECT_LE(fields::errors_of(fine, truth).rms, 0.4);
  EXPECT_LE(fields::errors_of(fine, truth).p95, 1);
  EXPECT_LE(fields::errors_of(fine, truth).max, 2);

  // So results at two orientations differ by no more than two independent errors.
  EXPECT_LE(fields::errors_of(draft, diffused(Quality::draft, fruit, points)).rms, 1.4);
  const fields::Errors between = fields::errors_of(fine, diffused(Quality::final, fruit, points));
  EXPECT_LE(between.rms, 0.5);
  EXPECT_LE(between.max, 3);
}

TEST(PmvcError, LinearFieldsHoldAtAnyQuality) {
  const DiffusionSurfaces scene = fields::linear_scene();
  const std::vector<glm::vec3> points = fields::points_in_linear_scene();
  for (const Quality quality : {Quality::draft, Quality::final, Quality::reference}) {
    const std::vector<Color> colors = diffused(quality, scene, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_LE(glm::length(glm::dvec3(colors[i]) - fields::dyadic_linear(glm::dvec3(points[i]))), 1e-5) << i;
    }
  }
}

TEST(PmvcError, ShellWithinTheErrorsOfDraftAndFinal) {
  shapes::Paint inner, outer;
  inner.front = inner.back = Color(1);
  outer.front = outer.back = Color(0);
  const DiffusionSurfaces shell = joined(shapes::sphere(0.4, 32, inner), shapes::sphere(1, 32, outer));
  const std::vector<glm::vec3> points{{0, 0.5f, 0}, {0, 0.7f, 0}, {0.9f, 0, 0}, {0.4041f, 0.4041f, 0.4041f}};
  const std::vector<double> exact{0.576000, 0.136582, 0.025501, 0.136582};
  const std::vector<Color> draft = diffused(Quality::draft, shell, points);
  const std::vector<Color> fine = diffused(Quality::final, shell, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(draft[i].x, exact[i], 3.0 / 255) << i;
    EXPECT_NEAR(fine[i].x, exact[i], 1.0 / 255) << i;
  }
}

TEST(PmvcError, PlatesAndPolynomialWithinTheErrorOfFinal) {
  shapes::Paint lower, upper;
  lower.front = lower.back = Color(1);
  upper.front = upper.back = Color(0);
  const DiffusionSurfaces plates = shapes::two_plates(200, 1, lower, upper, 8);
  EXPECT_NEAR(diffused(Quality::final, plates, {{0.3f, -0.25f, 0.2f}}).front().x, 0.75, 1.0 / 255);

  const DiffusionSurfaces sphere = fields::painted_with(shapes::sphere(1, 32), [](const glm::dvec3& p) {
    const double cosine = p.y / glm::length(p);
    return glm::dvec3(0.5 * (3 * cosine * cosine - 1));
  });
  EXPECT_NEAR(diffused(Quality::final, sphere, {{0, 0.5f, 0}}).front().x, 0.2648, 1.0 / 255);
}

}  // namespace
}  // namespace pomona
