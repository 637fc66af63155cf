#include "generator/scene/settle/arrange.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/mesh/triangle_tree.h"
#include "generator/scene/settle/settle.h"
#include "tests/scene/heap_shapes.h"

namespace pomona {
namespace {

using heap_shapes::ball;
using heap_shapes::slab;
using heap_shapes::tray;

std::vector<SettleItem> arranged_items(int count, int solids) {
  std::vector<SettleItem> items;
  for (int i = 0; i < count; ++i)
    items.push_back({.solid = i % solids, .name = "piece-" + std::to_string(i), .arrangement = 0, .fruit = 0});
  return items;
}

DishForm on(const Solid& dish) {
  DishForm form(&dish);
  form.turned = false;
  form.on_top = true;
  form.name = "board";
  return form;
}

DishForm in(const Solid& dish) {
  DishForm form = on(dish);
  form.on_top = false;
  form.name = "tray";
  return form;
}

SettleOptions with(const PieceArrangement& how) {
  SettleOptions options;
  options.arrangements = {how};
  return options;
}

/// The bounding box of a solid in its pose.
Box<double> placed_box(const Solid& solid, const Pose& pose) {
  Box<double> box;
  for (const glm::vec3& p : solid.mesh.position) box.add(pose.rotation * glm::dvec3(p) + pose.translation);
  return box;
}

TEST(Arrange, AGridHasItsSpacingAndLiesOnTheBoard) {
  const std::vector<Solid> solids{ball(0.02), heap_shapes::wedge(0.02, 60)};
  const Solid board = slab({0.4, 0.02, 0.3});
  const Settled settled =
      settle(solids, arranged_items(12, 2), on(board),
             with({.kind = PieceArrangementKind::grid, .at = {0.01, -0.02}, .columns = 4, .spacing = {0.06, 0.07}}));
  for (std::size_t i = 0; i < 12; ++i) {
    const Box<double> box = placed_box(solids[i % 2], settled.poses[i]);
    EXPECT_NEAR(box.center().x, 0.01 + (static_cast<double>(i % 4) - 1.5) * 0.06, 2e-4) << i;
    EXPECT_NEAR(box.center().z, -0.02 + (static_cast<double>(i / 4) - 1.0) * 0.07, 2e-4) << i;
    EXPECT_NEAR(box.low.y, 0.02, 4e-4) << i;
  }
}

/// The tolerance is the error of a ball's samples, 2 mm apart.
TEST(Arrange, RowsKeepTheirGap) {
  const std::vector<Solid> solids{ball(0.02), ball(0.03)};
  const Solid board = slab({0.6, 0.02, 0.3});
  const Settled settled = settle(solids, arranged_items(6, 2), on(board),
                                 with({.kind = PieceArrangementKind::rows, .columns = 6, .gap = 0.004}));
  for (std::size_t i = 1; i < 6; ++i)
    EXPECT_NEAR(settled.poses[i].translation.x - settled.poses[i - 1].translation.x, 0.054, 8e-4) << i;
}

/// Every piece touches the hill, which is not flat, and no other piece; and pieces lie on all parts of the hill.
TEST(Arrange, ScatteredPiecesLieOnTheMesh) {
  const std::vector<Solid> solids{ball(0.01), heap_shapes::wedge(0.012, 90)};
  const Solid hill = ball(0.15);
  Solid half = hill;  // the lower half is moved below the ground
  for (glm::vec3& p : half.mesh.position) p.y = std::max(p.y, 0.0f);
  const Settled settled =
      settle(solids, arranged_items(60, 2), on(half), with({.kind = PieceArrangementKind::scatter, .gap = 0.002}));
  const TriangleTree surface(half.mesh.position, half.mesh.triangle);
  int left = 0;
  for (std::size_t i = 0; i < settled.poses.size(); ++i) {
    EXPECT_LE(settled.fits[i].gap, 0.02) << i;
    EXPECT_LE(settled.fits[i].penetration, 0.02) << i;
    double nearest = 1;
    for (const glm::vec3& p : solids[i % 2].mesh.position)
      nearest = std::min(
          nearest, surface.nearest(settled.poses[i].rotation * glm::dvec3(p) + settled.poses[i].translation).distance);
    EXPECT_LT(nearest, 5e-4) << i;
    left += settled.poses[i].translation.x < 0 ? 1 : 0;
  }
  EXPECT_GT(left, 15);
  EXPECT_LT(left, 45);
}

/// Slices of a sausage: a stack of discs of one fruit, each where it was cut.
TEST(Arrange, WhatIsCutFallsInItsOrder) {
  std::vector<Solid> slices;
  std::vector<SettleItem> items;
  constexpr int count = 9;
  for (int i = 0; i < count; ++i) {
    slices.push_back(heap_shapes::disc(0.02, 0.006));
    for (glm::vec3& p : slices.back().mesh.position) p.y += 0.006f * static_cast<float>(i);
    // In arbitrary order.
    items.push_back({.solid = (4 * i) % count, .name = "slice-" + std::to_string((4 * i) % count), .arrangement = 0});
  }
  const Solid board = slab({0.4, 0.02, 0.3});
  const Settled settled = settle(slices, items, on(board), with({.kind = PieceArrangementKind::as_cut, .gap = 0.002}));
  std::vector<double> along(count);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto solid = static_cast<std::size_t>(items[i].solid);
    along[solid] = placed_box(slices[solid], settled.poses[i]).center().x;
  }
  EXPECT_TRUE(std::is_sorted(along.begin(), along.end())) << testing::PrintToString(along);
}

/// Slices across z face +z or -z, so that z, the last axis, must be found.
TEST(Arrange, WhatIsCutFromFrontToBackFallsInItsOrder) {
  for (const float side : {1.0f, -1.0f}) {
    std::vector<Solid> slices;
    std::vector<SettleItem> items;
    for (int i = 0; i < 3; ++i) {
      slices.push_back(heap_shapes::disc(0.02, 0.006));
      for (glm::vec3& p : slices.back().mesh.position)
        p = {p.x, -side * p.z, side * p.y + 0.006f * static_cast<float>(i)};
      // Only one face is cut: all slices face the same way.
      for (std::size_t t = 0; t < slices.back().mesh.triangle.size(); ++t) {
        const glm::uvec3& corner = slices.back().mesh.triangle[t];
        const std::vector<glm::vec3>& at = slices.back().mesh.position;
        const glm::vec3 area = glm::cross(at[corner.y] - at[corner.x], at[corner.z] - at[corner.x]);
        slices.back().mesh.cut_face[t] = side * area.z > 0.5f * glm::length(area) ? 0 : -1;
      }
      items.push_back({.solid = i, .name = "slice-" + std::to_string(i), .arrangement = 0});
    }
    const Solid board = slab({0.4, 0.02, 0.3});
    const Settled settled =
        settle(slices, items, on(board), with({.kind = PieceArrangementKind::as_cut, .gap = 0.002}));
    std::vector<double> along;
    for (std::size_t i = 0; i < 3; ++i) along.push_back(placed_box(slices[i], settled.poses[i]).center().x);
    EXPECT_TRUE(std::is_sorted(along.begin(), along.end())) << side << ' ' << testing::PrintToString(along);
  }
}

TEST(Arrange, ATrayHoldsWhatFallsIntoIt) {
  const std::vector<Solid> solids{ball(0.015), heap_shapes::wedge(0.02, 120)};
  const Solid crate = tray({0.3, 0.08, 0.2}, 0.008);
  std::vector<SettleItem> items = arranged_items(50, 2);
  for (SettleItem& item : items) item.arrangement = -1;
  const Settled settled = settle(solids, items, in(crate));
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Box<double> box = placed_box(solids[i % 2], settled.poses[i]);
    EXPECT_GT(box.low.x, -0.151) << i;
    EXPECT_LT(box.high.x, 0.151) << i;
    EXPECT_GT(box.low.z, -0.101) << i;
    EXPECT_LT(box.high.z, 0.101) << i;
    EXPECT_GT(box.low.y, 0.007) << i;
    EXPECT_LE(settled.fits[i].gap, 0.02) << i;
    EXPECT_LE(settled.fits[i].penetration, 0.02) << i;
  }
}

TEST(Arrange, IsTheSameForAnyNumberOfThreads) {
  const std::vector<Solid> solids{heap_shapes::ring(0.02, 0.012, 0.006), heap_shapes::wedge(0.02, 90)};
  const Solid crate = tray({0.3, 0.08, 0.2}, 0.008);
  std::vector<SettleItem> items = arranged_items(16, 2);
  for (std::size_t i = 8; i < 16; ++i) items[i].arrangement = -1;
  SettleOptions one = with({.kind = PieceArrangementKind::rows, .columns = 4}), two = one;
  one.threads = {1};
  two.threads = {2};
  const Settled a = settle(solids, items, in(crate), one), b = settle(solids, items, in(crate), two);
  for (std::size_t i = 0; i < items.size(); ++i) {
    EXPECT_EQ(a.poses[i].rotation, b.poses[i].rotation) << i;
    EXPECT_EQ(a.poses[i].translation, b.poses[i].translation) << i;
  }
}

template <typename Run>
void expect_refused(ExitStatus status, const std::string& message, const Run& run) {
  try {
    run();
    ADD_FAILURE() << "was not refused: " << message;
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), status);
    EXPECT_THAT(to_string(error.diagnostics().front()), testing::HasSubstr(message));
    EXPECT_THAT(to_string(error.diagnostics().front()), testing::StartsWith("scene.toml:7:"));
  }
}

TEST(Arrange, WhatCannotBeIsNamed) {
  const std::vector<Solid> solids{ball(0.02)};
  std::vector<SettleItem> items = arranged_items(4, 1);
  for (SettleItem& item : items) item.place = {"scene.toml", 7, 8, {}};
  const Solid board = slab({0.3, 0.02, 0.2}), wall = heap_shapes::upright_sheet(0.2);

  // A dish without a hollow; too many pieces; a mesh without an upper side.
  std::vector<SettleItem> falling = items;
  for (SettleItem& item : falling) item.arrangement = -1;
  expect_refused(ExitStatus::bad_data, "\"tray\" has no hollow", [&] { settle(solids, falling, in(board)); });
  expect_refused(ExitStatus::some_items_failed, "piece \"piece-0\" lies outside the board", [&] {
    settle(solids, items, on(board), with({.kind = PieceArrangementKind::grid, .columns = 4, .spacing = {0.2, 0.2}}));
  });
  expect_refused(ExitStatus::some_items_failed, "overlaps by", [&] {
    settle(solids, items, on(board), with({.kind = PieceArrangementKind::grid, .columns = 4, .spacing = {0.02, 0.2}}));
  });
  expect_refused(ExitStatus::bad_data, "\"board\" has no area that looks upwards",
                 [&] { settle(solids, items, on(wall), with({.kind = PieceArrangementKind::scatter})); });
  expect_refused(ExitStatus::some_items_failed, "finds no room", [&] {
    std::vector<SettleItem> many;
    for (int i = 0; i < 12; ++i) many.push_back(items[0]), many.back().name += "-" + std::to_string(i);
    settle(solids, many, on(slab({0.1, 0.02, 0.1})), with({.kind = PieceArrangementKind::scatter}));
  });
}

}  // namespace
}  // namespace pomona
