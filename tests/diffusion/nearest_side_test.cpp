#include "generator/diffusion/nearest_side.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "tests/shapes/seeded_fruit.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

SurfaceSide nearest(const DiffusionSurfaces& surfaces, const glm::dvec3& point) {
  return nearest_side(surfaces, make_surface_tree(surfaces), point).value();
}

TEST(NearestSide, TellsInsideFromOutside) {
  const DiffusionSurfaces box = shapes::box({-1, -1, -1}, {1, 1, 1}, 2);
  EXPECT_EQ(nearest(box, {0.2, 0.9, 0.1}).side, SideOf::back);
  EXPECT_EQ(nearest(box, {0.2, 1.5, 0.1}).side, SideOf::front);
  EXPECT_NEAR(nearest(box, {0.2, 1.5, 0.1}).distance, 0.5, 1e-12);
}

TEST(NearestSide, TellsThemApartAtEdgesAndCornersToo) {
  const DiffusionSurfaces box = shapes::tilted(shapes::box({-1, -0.1, -1}, {1, 0.1, 1}, 3));
  for (const glm::vec3& corner : box.position) {
    const glm::dvec3 p(corner);
    EXPECT_EQ(nearest(box, p * 1.2).side, SideOf::front) << p.x << " " << p.y << " " << p.z;
  }
}

TEST(NearestSide, ColourIsThatOfThePlace) {
  DiffusionSurfaces sheet = shapes::open_sheet(2, 0, 1);
  for (std::size_t v = 0; v < sheet.vertex_count(); ++v) {
    sheet.front_color[v] = Color(sheet.position[v].x, 0, 0);
    sheet.back_color[v] = Color(0, sheet.position[v].z, 0);
  }
  EXPECT_NEAR(color_of(sheet, nearest(sheet, {0.5, 0.1, 0.2})).x, 0.5, 1e-12);
  EXPECT_NEAR(color_of(sheet, nearest(sheet, {0.5, -0.1, 0.2})).y, 0.2, 1e-12);
}

TEST(NearestSide, RadiusLimitsTheSearch) {
  const DiffusionSurfaces box = shapes::box({-1, -1, -1}, {1, 1, 1}, 2);
  const SurfaceTree tree = make_surface_tree(box);
  EXPECT_FALSE(nearest_side(box, tree, {0, 0, 0}, 0.9).has_value());
  EXPECT_TRUE(nearest_side(box, tree, {0, 0, 0}, 1.1).has_value());
}

TEST(NearestSide, AgreesWithTryingAllTriangles) {
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  const SurfaceTree tree = make_surface_tree(fruit);
  const std::vector<glm::vec3> points = shapes::points_on_section_of_seeded_fruit(50);
  for (const glm::vec3& p : points) {
    double min = 1;
    for (std::uint32_t t = 0; t < fruit.triangle_count(); ++t) {
      const auto [a, b, c] = corners(fruit, t);
      // The nearest of many places on the triangle is not nearer than the exact one, and almost as near.
      for (int i = 0; i <= 8; ++i) {
        for (int j = 0; i + j <= 8; ++j) {
          const glm::dvec3 q =
              (a * static_cast<double>(i) + b * static_cast<double>(j) + c * static_cast<double>(8 - i - j)) / 8.0;
          min = std::min(min, glm::length(glm::dvec3(p) - q));
        }
      }
    }
    const double found = nearest_side(fruit, tree, glm::dvec3(p))->distance;
    EXPECT_LE(found, min * (1 + 1e-12));
    EXPECT_GE(found, min - 0.0006);
  }
}

TEST(SurfaceTree, NeedsATriangleWithArea) {
  DiffusionSurfaces sheet = shapes::open_sheet(1, 0, 1);
  for (glm::vec3& p : sheet.position) p = glm::vec3(p.x, 0, p.x);
  EXPECT_THROW(make_surface_tree(sheet), Error);
  EXPECT_THROW(make_surface_tree(DiffusionSurfaces{}), Error);
}

}  // namespace
}  // namespace pomona
