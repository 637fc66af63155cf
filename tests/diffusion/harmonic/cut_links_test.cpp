#include "generator/diffusion/harmonic/cut_links.h"

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

using shapes::LinkedShapes;

std::size_t number_of(const LinkedShapes& linked, const Node& node) {
  return static_cast<std::size_t>(linked.runs.node_at(node[0], node[1], node[2]));
}

bool is_in(const Lattice& lattice, const Node& node) {
  for (std::size_t a = 0; a < 3; ++a) {
    if (node[a] < 0 || node[a] >= lattice.count[a]) return false;
  }
  return true;
}

TEST(CutLinks, LetNothingThroughAClosedSurface) {
  for (const std::vector<Corners>& shape : shapes::convex_shapes()) {
    const LinkedShapes linked(shapes::surfaces_of(shape), shapes::whole_lattice());
    std::size_t cut = 0;
    for (const Node& node : shapes::nodes_of(linked.lattice)) {
      const bool is_inside = shapes::holds(shape, shapes::place_of(linked.lattice, node));
      for (int d = 0; d < 6; ++d) {
        const Node other = shapes::beside(node, d);
        const bool is_open = linked.is_open(node, d);
        if (!is_in(linked.lattice, other)) {
          EXPECT_FALSE(is_open) << "it leads to nowhere";
          continue;
        }
        EXPECT_EQ(is_open, linked.is_open(other, d ^ 1));
        if (shapes::holds(shape, shapes::place_of(linked.lattice, other)) == is_inside) continue;
        EXPECT_FALSE(is_open);
        ++cut;
      }
    }
    EXPECT_GT(cut, 10u);
  }
}

TEST(CutLinks, EndOnTheSideAndTheColourThatTheirNodeSees) {
  shapes::Paint paint;
  paint.front = Color(0.1f, 0.2f, 0.3f);
  paint.back = Color(0.9f, 0.8f, 0.7f);
  const DiffusionSurfaces ball = shapes::tilted(shapes::sphere(0.7, 5, paint));
  const LinkedShapes linked(ball, lattice_around(ball, 0.1, 1, 2, glm::dvec3(0.3)));
  const CutLinks links = linked.links();
  std::size_t pairs = 0;
  for (const Node& node : shapes::nodes_of(linked.lattice)) {
    const auto number = static_cast<std::uint32_t>(number_of(linked, node));
    const glm::dvec3 place = shapes::place_of(linked.lattice, node);
    for (int d = 0; d < 6; ++d) {
      const LinkCut* cut = shapes::cut_of(links, number, d);
      EXPECT_FALSE(cut != nullptr && linked.is_open(node, d)) << "cut and open";
      if (cut == nullptr) continue;
      const bool sees_front = cut->side % 2 == 0;
      const double out = glm::length(place);
      if (out < 0.66 || out > 0.7) {
        EXPECT_EQ(sees_front, out > 0.7) << "the ball's faces are flat: they lie somewhat deeper than their corners";
      }
      const Color& wanted = sees_front ? paint.front : paint.back;
      EXPECT_LT(glm::distance(cut->color, wanted), 1e-6f);

      // From the other end it is the same place.
      const Node other = shapes::beside(node, d);
      const LinkCut* back = shapes::cut_of(links, static_cast<std::uint32_t>(number_of(linked, other)), d ^ 1);
      ASSERT_NE(back, nullptr);
      if (back->side / 2 != cut->side / 2) continue;
      EXPECT_NE(back->side, cut->side);
      EXPECT_FLOAT_EQ(back->theta + cut->theta, 1);
      ++pairs;
    }
  }
  EXPECT_GT(pairs, 500u);
}

TEST(CutLinks, EndOnTheNearestOfTwoSurfaces) {
  // Two walls, 2 cm apart, across links of half a metre.
  const DiffusionSurfaces walls =
      joined(shapes::box({-2, -2, -2}, {2, 2, 2}), shapes::box({-2.02, -2.02, -2.02}, {2.02, 2.02, 2.02}));
  const LinkedShapes linked(walls, lattice_around(walls, 0.5, 1, 2, glm::dvec3(0.3)));
  const CutLinks links = linked.links();
  std::size_t cuts = 0;
  for (const Node& node : shapes::nodes_of(linked.lattice)) {
    const glm::dvec3 away = glm::abs(shapes::place_of(linked.lattice, node));
    const double out = std::max({away.x, away.y, away.z});
    ASSERT_FALSE(out > 2 && out < 2.02) << "no node lies between the walls";
    for (int d = 0; d < 6; ++d) {
      const LinkCut* cut = shapes::cut_of(links, static_cast<std::uint32_t>(number_of(linked, node)), d);
      if (cut == nullptr) continue;
      ++cuts;
      const bool sees_outer = cut->side / 2 >= 12, sees_front = cut->side % 2 == 0;
      EXPECT_EQ(sees_outer, out > 2);
      EXPECT_EQ(sees_front, out > 2);
    }
  }
  EXPECT_EQ(cuts, links.cut.size());
  EXPECT_GT(cuts, 200u);
}

TEST(CutLinks, SaysWhichSidesMarkedNodesSee) {
  const DiffusionSurfaces ball = shapes::sphere(0.7, 3);
  const LinkedShapes linked(ball, lattice_around(ball, 0.1, 1, 2, glm::dvec3(0.3)));
  std::vector<std::uint8_t> inside(linked.runs.size(), 0), outside = shapes::all_members(linked.runs);
  for (const Node& node : shapes::nodes_of(linked.lattice)) {
    if (glm::length(shapes::place_of(linked.lattice, node)) > 0.6) continue;
    const std::size_t number = number_of(linked, node);
    inside[number / 8] = static_cast<std::uint8_t>(inside[number / 8] | 1 << number % 8);
  }
  const std::vector<std::uint8_t> all = linked.finder.sides_seen(outside), within = linked.finder.sides_seen(inside);
  for (std::size_t t = 0; t < ball.triangle_count(); ++t) {
    EXPECT_EQ(all[t], 3);
    EXPECT_EQ(within[t] & 1, 0) << "no front is seen from within";
  }
}

TEST(CutLinks, AreOnlyThoseOfUnmarkedNodes) {
  const std::vector<Corners> shape = shapes::convex_shapes().front();
  const LinkedShapes linked(shapes::surfaces_of(shape), shapes::whole_lattice());
  std::vector<std::uint8_t> outside(linked.runs.size(), 0xff);
  for (const Node& node : shapes::nodes_of(linked.lattice)) {
    if (!shapes::holds(shape, shapes::place_of(linked.lattice, node))) continue;
    const std::size_t number = number_of(linked, node);
    outside[number / 8] = static_cast<std::uint8_t>(outside[number / 8] & ~(1 << number % 8));
  }
  const CutLinks links = linked.finder.links(linked.runs, outside);
  // The box from 1 to 3 holds nodes at 1 and 2: eight with three cuts each.
  EXPECT_EQ(links.node.size(), 8u);
  EXPECT_EQ(links.cut.size(), 24u);
  std::size_t parts = 0;
  for (const std::uint8_t open : links.open) {
    if (open & takes_no_part) continue;
    EXPECT_EQ(bit_counts[open], 3);
    ++parts;
  }
  EXPECT_EQ(parts, 8u);
}

TEST(CutLinks, AreTheSameWhetherAllNodesAreNamedOrMeant) {
  // With 16 nodes along x no run reaches beyond the lattice; with 13 and 17 the last does.
  for (const int count : {13, 16, 17}) {
    Lattice lattice = shapes::whole_lattice();
    lattice.count[0] = count;
    const LinkedShapes named(shapes::surfaces_of(shapes::convex_shapes().front()), lattice);
    const LinkFinder meant(named.snapped, shapes::all_triangles(named.surfaces), lattice, named.runs, Threads{2});
    EXPECT_EQ(meant.open(), named.finder.open());
  }
}

TEST(CutLinks, AppendKeepsWhoseCutsAreWhose) {
  CutLinks links;
  std::vector<CutLinks> parts(2);
  parts[0].node = {{3, 0, 0b11}};
  parts[0].cut = {{0.1f, 0, {}}, {0.2f, 1, {}}};
  parts[1].node = {{7, 0, 0b1}, {9, 1, 0b100}};
  parts[1].cut = {{0.3f, 2, {}}, {0.4f, 3, {}}};
  append(links, parts);
  EXPECT_EQ(shapes::cut_of(links, 3, 1)->theta, 0.2f);
  EXPECT_EQ(shapes::cut_of(links, 7, 0)->theta, 0.3f);
  EXPECT_EQ(shapes::cut_of(links, 9, 2)->theta, 0.4f);
}

TEST(CutLinks, FindTheTrianglesOfPlanes) {
  const Lattice lattice = shapes::whole_lattice();
  const DiffusionSurfaces shape = shapes::surfaces_of(shapes::convex_shapes().front());
  const std::vector<std::pair<int, int>> planes = {{0, 2}, {2, 4}, {4, 5}, {5, 9}};
  const auto lists = triangles_by_planes(snapped(shape, lattice), shapes::all_triangles(shape), lattice, planes);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    std::vector<std::uint8_t> listed(shape.triangle_count(), 0);
    for (const std::uint32_t t : lists[i]) listed[t] = 1;
    EXPECT_TRUE(std::is_sorted(lists[i].begin(), lists[i].end()));
    const auto found = link_crossings(snapped(shape, lattice), shapes::all_triangles(shape), lattice, planes[i].first,
                                      planes[i].second);
    for (const LinkCrossing& c : found) EXPECT_TRUE(listed[c.triangle]);
  }
  EXPECT_TRUE(lists[0].empty()) << "nothing is nearer than a plane to 3";
}

}  // namespace
}  // namespace pomona
