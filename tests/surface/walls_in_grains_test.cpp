// Walls end at grains. Grains are octahedra here, whose sections are squares.
#include "generator/surface/grains/walls_in_grains.h"

#include <cmath>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/mesh/edges.h"
#include "generator/mesh/weld.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

using namespace shapes;

constexpr double height = 0.1;
/// Half the diagonal of the square in which a wall at this height loses the place of an octahedron of radius 1.
const double half_diagonal = 0.95 - height;

DiffusionSurfaces grain(const glm::dvec3& at = {0, 0, 0}) { return moved(sphere(1, 1), at); }

/// The length of all edges that only one triangle has.
double rim_of(const DiffusionSurfaces& surfaces) {
  double sum = 0;
  for_each_edge(sorted_half_edges(welded_triangles(weld(surfaces.position), surfaces.triangle)),
                [&](std::span<const HalfEdge> edge) {
                  if (edge.size() == 1)
                    sum += glm::distance(glm::dvec3(surfaces.position[edge.front().low]),
                                         glm::dvec3(surfaces.position[edge.front().high]));
                });
  return sum;
}

/// A colour for a place, linear in it.
Color color_at(const glm::vec3& p) { return Color(0.5f + 0.1f * p.x, 0.4f - 0.05f * p.z, 0.3f + 0.1f * p.x * 0.5f); }

TEST(WallsInGrains, AWallEndsAtAGrain) {
  for (const int n : {1, 2, 7, 40}) {
    const DiffusionSurfaces wall = open_sheet(4, height, n);
    const DiffusionSurfaces left = without_walls_in_grains(wall, grain());
    EXPECT_NEAR(area(left), 16 - 2 * half_diagonal * half_diagonal, 1e-5) << n;
    // Nothing is torn: there is no other rim than those of the wall and of the hole.
    EXPECT_NEAR(rim_of(left), 16 + 4 * std::sqrt(2.0) * half_diagonal, 1e-4) << n;
  }
}

TEST(WallsInGrains, TheRimHasTheWallsColours) {
  DiffusionSurfaces wall = open_sheet(4, height, 3);
  for (std::size_t v = 0; v < wall.vertex_count(); ++v) {
    wall.front_color[v] = color_at(wall.position[v]);
    wall.back_color[v] = Color(1) - color_at(wall.position[v]);
  }
  const DiffusionSurfaces left = without_walls_in_grains(wall, grain());
  ASSERT_GT(left.vertex_count(), wall.vertex_count());
  for (std::size_t v = 0; v < left.vertex_count(); ++v) {
    EXPECT_FLOAT_EQ(left.position[v].y, static_cast<float>(height));
    EXPECT_LT(glm::distance(left.front_color[v], color_at(left.position[v])), 1e-6f);
    EXPECT_LT(glm::distance(left.back_color[v], Color(1) - color_at(left.position[v])), 1e-6f);
    EXPECT_EQ(left.front_hidden[v] + left.back_hidden[v], 0);
  }
  for (std::size_t t = 0; t < left.triangle_count(); ++t) {
    EXPECT_EQ(left.front_part[t], wall.front_part[0]);
    EXPECT_EQ(left.back_part[t], wall.back_part[0]);
  }
}

TEST(WallsInGrains, GrainsOnOneTriangleLeaveAHoleEach) {
  DiffusionSurfaces grains = grain({-1.2, 0, 0});
  grains = joined(grains, grain({1.2, 0.05, 0.3}));
  grains = joined(grains, grain({0, 5, 0}));
  const double higher = half_diagonal + 0.05;
  EXPECT_NEAR(area(without_walls_in_grains(open_sheet(40, height), grains)),
              1600 - 2 * half_diagonal * half_diagonal - 2 * higher * higher, 1e-3);
}

TEST(WallsInGrains, GrainsThatCrossEachOtherLeaveOneHole) {
  const double apart = 0.6;
  const DiffusionSurfaces grains = joined(grain({-apart / 2, 0, 0}), grain({apart / 2, 0, 0}));
  // Two squares on their corners share a smaller one.
  const double shared = half_diagonal - apart / 2;
  for (const int n : {1, 2, 40})
    EXPECT_NEAR(area(without_walls_in_grains(open_sheet(4, height, n), grains)),
                16 - 4 * half_diagonal * half_diagonal + 2 * shared * shared, 1e-5);
}

TEST(WallsInGrains, NothingIsLeftWithinAGrain) {
  EXPECT_EQ(without_walls_in_grains(open_sheet(0.4, height, 3), grain()).triangle_count(), 0u);
  EXPECT_EQ(without_walls_in_grains(sphere(0.3, 4), grain()).triangle_count(), 0u);
}

TEST(WallsInGrains, WhatFacesAirStays) {
  const DiffusionSurfaces skin = sphere(0.8, 5, skin_paint());
  const DiffusionSurfaces left = without_walls_in_grains(skin, grain({0.5, 0, 0}));
  EXPECT_EQ(left.triangle, skin.triangle);
  EXPECT_EQ(left.position, skin.position);
}

TEST(WallsInGrains, WhatIsSparedKeepsItsWall) {
  const DiffusionSurfaces stone = sphere(0.8, 5);
  const std::vector<int> spared = {stone.back_part[0]};
  EXPECT_LT(area(without_walls_in_grains(stone, grain({0.9, 0, 0}))), 0.9 * area(stone));
  EXPECT_EQ(without_walls_in_grains(stone, grain({0.9, 0, 0}), spared).triangle, stone.triangle);
}

TEST(WallsInGrains, WallsElsewhereKeepTheirBytes) {
  const DiffusionSurfaces wall = open_sheet(4, height, 7);
  for (const DiffusionSurfaces& grains : {grain({0, 3, 0}), grain({9, 0, 0}), DiffusionSurfaces()}) {
    const DiffusionSurfaces left = without_walls_in_grains(wall, grains);
    EXPECT_EQ(left.triangle, wall.triangle);
    EXPECT_EQ(left.position, wall.position);
  }
}

TEST(WallsInGrains, ThreadsDoNotMatter) {
  DiffusionSurfaces grains;
  for (int i = 0; i < 40; ++i) grains = joined(grains, grain({2.2 * (i % 8), 0.02 * i, 2.2 * (i / 8)}));
  const DiffusionSurfaces wall = open_sheet(60, height, 90);
  const DiffusionSurfaces one = without_walls_in_grains(wall, grains, {}, {1});
  const DiffusionSurfaces many = without_walls_in_grains(wall, grains, {}, {3});
  EXPECT_NE(one.triangle, wall.triangle);
  EXPECT_EQ(one.triangle, many.triangle);
  EXPECT_EQ(one.position, many.position);
}

}  // namespace
}  // namespace pomona
