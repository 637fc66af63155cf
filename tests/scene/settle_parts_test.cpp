// Unit tests of settling: maps, funnels, waves, drop positions, distances.
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "generator/base/units.h"
#include "generator/mesh/triangle_tree.h"
#include "generator/scene/settle/drop.h"
#include "generator/scene/settle/heap_plan.h"
#include "generator/scene/settle/height_map.h"
#include "generator/scene/settle/mesh_dish.h"
#include "generator/scene/settle/piece_shape.h"
#include "generator/scene/settle/rigid_body_world.h"
#include "tests/scene/heap_shapes.h"

namespace pomona {
namespace {

DishForm in(const Solid& dish, bool on_top = false) {
  DishForm form(&dish);
  form.turned = false;
  form.on_top = on_top;
  return form;
}

/// Up to a cell's width, the resolution of the map.
TEST(HeightMap, ABowlIsAsHighOnEitherSide) {
  const Solid bowl = heap_shapes::bowl(0.12, 0.06);
  const Dish dish(&bowl, {});
  const HeightMap map(dish, 0.12, 0.008);
  const PieceShape shape = piece_shape(heap_shapes::ball(0.01), 0.02);
  const RigidBody ball(shape, {1, 0, 0, 0}, glm::dvec3(0));
  for (const float out : {0.03f, 0.05f, 0.07f, 0.08f}) {
    const float right = map.resting_height(ball, out, 0), left = map.resting_height(ball, -out, 0);
    const float near = map.resting_height(ball, 0, out), far = map.resting_height(ball, 0, -out);
    EXPECT_NEAR(right, left, 3e-3) << out;
    EXPECT_NEAR(near, far, 3e-3) << out;
    EXPECT_NEAR(right, near, 3e-3) << out;
  }
}

TEST(Dish, TheGroundBesideADishOfAnyShapeIsGround) {
  const Solid board = heap_shapes::slab({0.4, 0.02, 0.3});
  const Dish dish(in(board, true), {});
  EXPECT_NEAR(dish.distance({0, 0.03f, 0}), 0.01f, 1e-3);
  for (const float x : {0.22f, 0.3f, 1.0f, 5.0f}) {
    EXPECT_EQ(dish.distance({x, 0.004f, 0}), 0.004f) << x;
    EXPECT_EQ(dish.distance({x, -0.004f, 0}), -0.004f) << x;
  }
}

/// A ball thrown at each of the four walls, off the middle, stays inside.
TEST(RigidBodyWorld, FourWallsKeepWhatFalls) {
  const Dish ground({}, {});
  const PieceShape shape = piece_shape(heap_shapes::ball(0.01), 0.035);
  const Funnel walls{.low = 0, .from = {-0.1, -0.04}, .to = {0.12, 0.06}};
  for (const glm::dvec3& way : {glm::dvec3(1, 0, 0), {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}}) {
    RigidBodyWorld world(ground, 1, 0.035, shape.radius, {}, {1});
    world.set_funnel(walls);
    RigidBody ball(shape, {1, 0, 0, 0}, {0.01, 0.05, 0.01});
    ball.velocity = 0.002 * way;
    world.put(0, ball);
    world.run_until_rest();
    // It may be one step beyond the place where it is stopped.
    const glm::dvec3 at = world.bodies()[0].center;
    EXPECT_GT(at.x - shape.radius, walls.from.x - 0.0025) << way.x << ' ' << way.z;
    EXPECT_LT(at.x + shape.radius, walls.to.x + 0.0025) << way.x << ' ' << way.z;
    EXPECT_GT(at.z - shape.radius, walls.from.y - 0.0025) << way.x << ' ' << way.z;
    EXPECT_LT(at.z + shape.radius, walls.to.y + 0.0025) << way.x << ' ' << way.z;
    EXPECT_GT(glm::dot(at, way), 0.02) << "it was thrown there";
  }
}

/// The ring for the centres ends before the rim, because the pieces themselves are larger.
TEST(HeapPlan, AWaveCoversTheBowl) {
  const std::vector<Solid> solids{heap_shapes::ball(0.02)};
  const std::vector<SettleItem> items(100, {.solid = 0, .name = "ball"});
  const Solid bowl = heap_shapes::bowl(0.2, 0.08);
  const HeapPlan plan(solids, items, &bowl, {});
  const double covered = static_cast<double>(plan.pieces_in_wave(0)) * 0.04 * 0.04;
  const double open = pi * std::pow(plan.options().fill * plan.dish().rim_radius(), 2);
  EXPECT_GT(covered, 0.67 * open);
  EXPECT_LT(covered, open);
}

/// Its depth is not a whole number of cells, so the last row is only partly covered.
TEST(MeshDish, EveryPlaceOnABoardIsAsFarInsideAsItsBorderIsAway) {
  const glm::dvec3 size(0.512, 0.02, 0.2014);
  const Solid board = heap_shapes::slab(size);
  const MeshDish dish(board, TriangleTree(board.mesh.position, board.mesh.triangle), true);
  ASSERT_GT(dish.places().size(), 20000u);
  const double cell = std::sqrt(dish.cell_area());
  for (const MeshDish::Place& place : dish.places()) {
    const double away = std::min(0.5 * size.x - std::abs(place.at.x), 0.5 * size.z - std::abs(place.at.y));
    ASSERT_NEAR(place.inset, away + 0.5 * cell, 0.6 * cell) << place.at.x << ' ' << place.at.y;
  }
}

/// On a level floor all cells are equally likely.
TEST(RandomPlace, IsInAnyCellOfADish) {
  const Dish ground({}, {});
  const HeightMap map(ground, 0.1, 0.01);
  const PieceShape shape = piece_shape(heap_shapes::ball(0.01), 0.02);
  const RigidBody ball(shape, {1, 0, 0, 0}, glm::dvec3(0));
  DropCells cells;
  for (int i = 0; i < 5; ++i) cells.push_back({.at = {0.02 * i - 0.04, 0.01}, .inset = 0.1, .level = 0.1});
  const RandomStream draw({3, 0}, "tests/drop");
  std::set<long> found;
  for (std::uint64_t n = 0; n < 60; ++n) {
    const std::optional<glm::dvec3> place = random_place(ball, map, cells, draw, 100 * n);
    ASSERT_TRUE(place.has_value());
    EXPECT_NEAR(place->z, 0.01, 1e-6);
    found.insert(std::lround(place->x * 1e3));
  }
  EXPECT_EQ(found, (std::set<long>{-40, -20, 0, 20, 40}));
}

}  // namespace
}  // namespace pomona
