#include "generator/diffusion/harmonic/cut_arms.h"

#include <algorithm>
#include <array>
#include <vector>

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/diffusion/harmonic/crossings.h"
#include "tests/diffusion/harmonic/whole_shapes.h"

namespace pomona {
namespace {

using shapes::GriddedShapes;

std::size_t number_of(const GriddedShapes& gridded, const Node& node) {
  return static_cast<std::size_t>(gridded.blocks.node_at(node[0], node[1], node[2]));
}

bool is_in(const Lattice& lattice, const Node& node) {
  for (std::size_t a = 0; a < 3; ++a) {
    if (node[a] < 0 || node[a] >= lattice.count[a]) return false;
  }
  return true;
}

TEST(CutArms, LetNothingThroughAClosedSurface) {
  for (const std::vector<Corners>& shape : shapes::convex_shapes()) {
    const GriddedShapes gridded(shapes::surfaces_of(shape), shapes::whole_lattice());
    std::size_t cut = 0;
    for (const Node& node : shapes::nodes_of(gridded.lattice)) {
      const bool is_inside = shapes::holds(shape, shapes::place_of(gridded.lattice, node));
      for (int d = 0; d < 6; ++d) {
        const Node other = shapes::beside(node, d);
        const bool is_open = gridded.is_open(node, d);
        if (!is_in(gridded.lattice, other)) {
          EXPECT_FALSE(is_open) << "it leads to nowhere";
          continue;
        }
        EXPECT_EQ(is_open, gridded.is_open(other, d ^ 1));
        if (shapes::holds(shape, shapes::place_of(gridded.lattice, other)) == is_inside) continue;
        EXPECT_FALSE(is_open);
        ++cut;
      }
    }
    EXPECT_GT(cut, 10u);
  }
}

TEST(CutArms, EndOnTheSideAndTheColourThatTheirNodeSees) {
  shapes::Paint paint;
  paint.front = Color(0.1f, 0.2f, 0.3f);
  paint.back = Color(0.9f, 0.8f, 0.7f);
  const DiffusionSurfaces ball = shapes::tilted(shapes::sphere(0.7, 5, paint));
  const GriddedShapes gridded(ball, lattice_around(ball, 0.1, 1, 2, glm::dvec3(0.3)));
  const CutArms arms = gridded.arms();
  std::size_t pairs = 0;
  for (const Node& node : shapes::nodes_of(gridded.lattice)) {
    const auto number = static_cast<std::uint32_t>(number_of(gridded, node));
    const glm::dvec3 place = shapes::place_of(gridded.lattice, node);
    for (int d = 0; d < 6; ++d) {
      const ArmCut* cut = shapes::cut_of(arms, number, d);
      EXPECT_FALSE(cut != nullptr && gridded.is_open(node, d)) << "cut and open";
      if (cut == nullptr) continue;
      const bool sees_front = cut->side % 2 == 0;
      const double out = glm::length(place);
      if (out < 0.66 || out > 0.7) {
        EXPECT_EQ(sees_front, out > 0.7) << "the ball's faces are flat: they lie somewhat deeper than their corners";
      }
      const Color& wanted = sees_front ? paint.front : paint.back;
      EXPECT_LT(glm::distance(cut->color, wanted), 1e-6f);

      // The cut has the same place when seen from the other end.
      const Node other = shapes::beside(node, d);
      const ArmCut* back = shapes::cut_of(arms, static_cast<std::uint32_t>(number_of(gridded, other)), d ^ 1);
      ASSERT_NE(back, nullptr);
      if (back->side / 2 != cut->side / 2) continue;
      EXPECT_NE(back->side, cut->side);
      EXPECT_FLOAT_EQ(back->theta + cut->theta, 1);
      ++pairs;
    }
  }
  EXPECT_GT(pairs, 500u);
}

TEST(CutArms, EndOnTheNearestOfTwoSurfaces) {
  // Two walls, 2 cm apart, across arms of half a metre.
  const DiffusionSurfaces walls =
      joined(shapes::box({-2, -2, -2}, {2, 2, 2}), shapes::box({-2.02, -2.02, -2.02}, {2.02, 2.02, 2.02}));
  const GriddedShapes gridded(walls, lattice_around(walls, 0.5, 1, 2, glm::dvec3(0.3)));
  const CutArms arms = gridded.arms();
  std::size_t cuts = 0;
  for (const Node& node : shapes::nodes_of(gridded.lattice)) {
    const glm::dvec3 away = glm::abs(shapes::place_of(gridded.lattice, node));
    const double out = std::max({away.x, away.y, away.z});
    ASSERT_FALSE(out > 2 && out < 2.02) << "no node lies between the walls";
    for (int d = 0; d < 6; ++d) {
      const ArmCut* cut = shapes::cut_of(arms, static_cast<std::uint32_t>(number_of(gridded, node)), d);
      if (cut == nullptr) continue;
      ++cuts;
      const bool sees_outer = cut->side / 2 >= 12, sees_front = cut->side % 2 == 0;
      EXPECT_EQ(sees_outer, out > 2);
      EXPECT_EQ(sees_front, out > 2);
    }
  }
  EXPECT_EQ(cuts, arms.cut.size());
  EXPECT_GT(cuts, 200u);
}

TEST(CutArms, SaysWhichSidesMarkedNodesSee) {
  const DiffusionSurfaces ball = shapes::sphere(0.7, 3);
  const GriddedShapes gridded(ball, lattice_around(ball, 0.1, 1, 2, glm::dvec3(0.3)));
  std::vector<std::uint8_t> inside(gridded.blocks.size(), 0), outside = shapes::all_members(gridded.blocks);
  for (const Node& node : shapes::nodes_of(gridded.lattice)) {
    if (glm::length(shapes::place_of(gridded.lattice, node)) > 0.6) continue;
    const std::size_t number = number_of(gridded, node);
    inside[number / 8] = static_cast<std::uint8_t>(inside[number / 8] | 1 << number % 8);
  }
  const std::vector<std::uint8_t> all = gridded.finder.sides_seen(outside), within = gridded.finder.sides_seen(inside);
  for (std::size_t t = 0; t < ball.triangle_count(); ++t) {
    EXPECT_EQ(all[t], 3);
    EXPECT_EQ(within[t] & 1, 0) << "no front is seen from within";
  }
}

TEST(CutArms, AreOnlyThoseOfUnmarkedNodes) {
  const std::vector<Corners> shape = shapes::convex_shapes().front();
  const GriddedShapes gridded(shapes::surfaces_of(shape), shapes::whole_lattice());
  std::vector<std::uint8_t> outside(gridded.blocks.size(), 0xff);
  for (const Node& node : shapes::nodes_of(gridded.lattice)) {
    if (!shapes::holds(shape, shapes::place_of(gridded.lattice, node))) continue;
    const std::size_t number = number_of(gridded, node);
    outside[number / 8] = static_cast<std::uint8_t>(outside[number / 8] & ~(1 << number % 8));
  }
  const CutArms arms = gridded.finder.arms(gridded.blocks, outside);
  // The box from 1 to 3 holds nodes at 1 and 2: eight with three cuts each.
  EXPECT_EQ(arms.node.size(), 8u);
  EXPECT_EQ(arms.cut.size(), 24u);
  std::size_t parts = 0;
  for (const std::uint8_t open : arms.open) {
    if (open & takes_no_part) continue;
    EXPECT_EQ(bit_counts[open], 3);
    ++parts;
  }
  EXPECT_EQ(parts, 8u);
}

TEST(CutArms, AreTheSameWhetherAllNodesAreNamedOrMeant) {
  // With 16 nodes along x no block reaches beyond the lattice; with 13 and 17 the last does.
  for (const int count : {13, 16, 17}) {
    Lattice lattice = shapes::whole_lattice();
    lattice.count[0] = count;
    const GriddedShapes named(shapes::surfaces_of(shapes::convex_shapes().front()), lattice);
    const ArmFinder meant(named.snapped, shapes::all_triangles(named.surfaces), lattice, named.blocks, Threads{2});
    EXPECT_EQ(meant.open(), named.finder.open());
  }
}

TEST(CutArms, AppendKeepsWhoseCutsAreWhose) {
  CutArms arms;
  std::vector<CutArms> parts(2);
  parts[0].node = {{3, 0, 0b11}};
  parts[0].cut = {{0.1f, 0, {}}, {0.2f, 1, {}}};
  parts[1].node = {{7, 0, 0b1}, {9, 1, 0b100}};
  parts[1].cut = {{0.3f, 2, {}}, {0.4f, 3, {}}};
  append(arms, parts);
  EXPECT_EQ(shapes::cut_of(arms, 3, 1)->theta, 0.2f);
  EXPECT_EQ(shapes::cut_of(arms, 7, 0)->theta, 0.3f);
  EXPECT_EQ(shapes::cut_of(arms, 9, 2)->theta, 0.4f);
}

TEST(CutArms, FindTheTrianglesOfPlanes) {
  const Lattice lattice = shapes::whole_lattice();
  const DiffusionSurfaces shape = shapes::surfaces_of(shapes::convex_shapes().front());
  const std::vector<std::pair<int, int>> planes = {{0, 2}, {2, 4}, {4, 5}, {5, 9}};
  const auto lists = triangles_by_planes(snapped(shape, lattice), shapes::all_triangles(shape), lattice, planes);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    std::vector<std::uint8_t> listed(shape.triangle_count(), 0);
    for (const std::uint32_t t : lists[i]) listed[t] = 1;
    EXPECT_TRUE(std::is_sorted(lists[i].begin(), lists[i].end()));
    const auto found = arm_crossings(snapped(shape, lattice), shapes::all_triangles(shape), lattice, planes[i].first,
                                     planes[i].second);
    for (const ArmCrossing& c : found) EXPECT_TRUE(listed[c.triangle]);
  }
  EXPECT_TRUE(lists[0].empty()) << "nothing is nearer than a plane to 3";
}

}  // namespace
}  // namespace pomona
