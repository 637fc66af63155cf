// The first step of a cut: where its points lie, and how it divides triangles.
#include "generator/cut/plane/split.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/knife/knife.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

Knife along(const glm::dvec3& normal, double offset) {
  return {PlaneCut(PlaneKnife{{glm::normalize(normal), offset}}), "plane"};
}

SplitMesh split_by(const DiffusionSurfaces& surfaces, const std::vector<Knife>& knives) {
  return split(surfaces, cut_planes(knives, bounds_of(surfaces)));
}

/// A box's side lies in a plane that comes after others, which have put points on the side's edges by then.
TEST(Split, PointsLieInAPlaneAcrossAnAxisToTheBitHoweverLateItComes) {
  const DiffusionSurfaces box = shapes::box({-0.03, -0.02, -0.01}, {0.0371, 0.0423, 0.0511}, 3);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 across(0);
    across[axis] = 1;
    const double side = bounds_of(box).high[axis];
    const SplitMesh mesh = split_by(
        box, {along({1, 2, 3}, 0.013), along({3, -1, 1}, 0.0037), along({-2, 1, 2}, 0.0171), along(across, side)});
    int made = 0;
    for (std::size_t p = 0; p < mesh.point.size(); ++p) {
      if (!mesh.sets.has(mesh.planes_of[p], 3)) continue;
      EXPECT_EQ(mesh.point[p][axis], side);
      made += mesh.sets.planes_in(mesh.planes_of[p]).size() > 1;
    }
    EXPECT_GT(made, 5) << "points of earlier planes";
  }
}

/// The four-sided rest is divided along its shorter diagonal, wherever the fruit lies.
TEST(Split, DividesTheRestOfATriangleAlongItsShorterDiagonal) {
  for (const glm::dvec3& place : {glm::dvec3(0), {0.5, 0.2, -0.3}, {-0.4, 0.1, 0.6}}) {
    const DiffusionSurfaces ball = shapes::moved(shapes::sphere(0.05, 4), place);
    const glm::dvec3 normal(1, 2, 3);
    const SplitMesh mesh = split_by(ball, {along(normal, glm::dot(glm::normalize(normal), place) + 0.0123)});

    // The two parts of a triangle that lie on one side share two corners, and each has one of its own.
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::array<std::uint32_t, 3>>> parts;
    for (const SplitMesh::Triangle& t : mesh.triangle) parts[{t.source, t.cell}].push_back(t.vertex);
    int pairs = 0;
    for (const auto& [of, triangles] : parts) {
      if (triangles.size() != 2) continue;
      std::vector<glm::dvec3> shared, own;
      for (const std::size_t i : {0u, 1u}) {
        const auto& other = triangles[1 - i];
        for (const std::uint32_t v : triangles[i]) {
          const bool is_shared = std::find(other.begin(), other.end(), v) != other.end();
          if (!is_shared) own.push_back(mesh.place_of(v));
          if (is_shared && i == 0) shared.push_back(mesh.place_of(v));
        }
      }
      ASSERT_EQ(shared.size(), 2u);
      ASSERT_EQ(own.size(), 2u);
      EXPECT_LE(glm::distance(shared[0], shared[1]), glm::distance(own[0], own[1]) + 1e-12);
      ++pairs;
    }
    EXPECT_GT(pairs, 10);
  }
}

}  // namespace
}  // namespace pomona
