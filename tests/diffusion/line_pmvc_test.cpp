// Only points whose colours scatter get more lines.
#include "generator/diffusion/pmvc/line_pmvc.h"

#include <vector>

#include <gtest/gtest.h>

#include "generator/base/units.h"
#include "generator/diffusion/pmvc/relaxed_lines.h"
#include "generator/diffusion/surface_tree.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

/// Values at points away from the middle, where lines have all lengths, so that weights scatter whether colours do or
/// not.
std::vector<PmvcValue> off_the_middle(const DiffusionSurfaces& surfaces, const LinePlan& plan) {
  const std::vector<glm::vec3> points{{0.5f, 0.2f, 0.1f}, {-0.1f, 0.7f, 0.3f}};
  return line_pmvc(surfaces, make_surface_tree(surfaces), points, plan, {1});
}

LinePlan with_draft_lines_alone() {
  LinePlan plan;
  plan.lines = relaxed_draft_lines();
  return plan;
}

LinePlan with_max_scatter(double max) {
  return {.lines = relaxed_draft_lines(), .more = relaxed_final_lines(), .max_scatter = max};
}

/// From the middle of a sphere the distance is its radius in all directions, so the weight is 4 pi / radius.
TEST(LinePmvc, WeightsAreAllDirectionsOverTheirDistance) {
  for (const double radius : {0.01, 0.5, 1.0, 3.0}) {
    const DiffusionSurfaces ball = shapes::sphere(radius, 12);
    const std::vector<glm::vec3> middle{{0, 0, 0}};
    const PmvcValue value = line_pmvc(ball, make_surface_tree(ball), middle, with_draft_lines_alone(), {1})[0];
    EXPECT_NEAR(value.weight, 4 * pi / radius, 0.03 * 4 * pi / radius) << radius;
  }
}

TEST(LinePmvc, OneColourScattersNowhere) {
  const DiffusionSurfaces ball = shapes::sphere(1, 6);
  const std::vector<PmvcValue> few = off_the_middle(ball, with_draft_lines_alone());
  const std::vector<PmvcValue> max = off_the_middle(ball, with_max_scatter(1e-3));
  for (std::size_t i = 0; i < few.size(); ++i)
    EXPECT_EQ(few[i].weight, max[i].weight) << "further lines were looked along";
}

TEST(LinePmvc, WhatScattersMoreThanMayBeIsLookedAtAlongMoreLines) {
  DiffusionSurfaces ball = shapes::sphere(1, 6);
  for (std::size_t v = 0; v < ball.vertex_count(); ++v)
    ball.back_color[v] = Color(ball.position[v].x > 0 ? 0.9f : 0.1f);
  const std::vector<PmvcValue> few = off_the_middle(ball, with_draft_lines_alone());
  const std::vector<PmvcValue> more = off_the_middle(ball, with_max_scatter(1e-3));
  const std::vector<PmvcValue> content = off_the_middle(ball, with_max_scatter(1));
  for (std::size_t i = 0; i < few.size(); ++i) {
    EXPECT_NE(few[i].weight, more[i].weight);
    EXPECT_EQ(few[i].weight, content[i].weight);
  }
}

}  // namespace
}  // namespace pomona
