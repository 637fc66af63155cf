#include "generator/diffusion/harmonic/nearest_labels.h"

#include <algorithm>
#include <deque>
#include <map>
#include <vector>

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "tests/diffusion/harmonic/whole_shapes.h"

namespace pomona {
namespace {

/// How many links each node is from the nearest that one of its own links leads from to a surface.
std::vector<int> steps_to_surface(const shapes::LinkedShapes& linked, const CutLinks& links) {
  std::vector<int> steps(linked.runs.node_count(), -1);
  std::deque<Node> waiting;
  const auto number_of = [&](const Node& n) { return static_cast<std::size_t>(linked.runs.node_at(n[0], n[1], n[2])); };
  for (const Node& node : shapes::nodes_of(linked.lattice)) {
    const auto of =
        std::find_if(links.node.begin(), links.node.end(), [&](const CutNode& c) { return c.node == number_of(node); });
    if (of == links.node.end() || of->cut == 0) continue;
    steps[number_of(node)] = 0;
    waiting.push_back(node);
  }
  for (; !waiting.empty(); waiting.pop_front()) {
    const Node node = waiting.front();
    for (int d = 0; d < 6; ++d) {
      if (!linked.is_open(node, d)) continue;
      const Node other = shapes::beside(node, d);
      if (steps[number_of(other)] >= 0) continue;
      steps[number_of(other)] = steps[number_of(node)] + 1;
      waiting.push_back(other);
    }
  }
  return steps;
}

TEST(NearestLabels, AreTheSidesThatNodesSeeAndNeverThoseBehindAWall) {
  const DiffusionSurfaces boxes =
      joined(shapes::box({-1, -1, -1}, {1, 1, 1}), shapes::box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}));
  const shapes::LinkedShapes linked(boxes, lattice_around(boxes, 0.13, 1, 2, glm::dvec3(0.3)));
  const GridLevel level = make_grid_level(linked.lattice, linked.runs, linked.links(), glm::dvec3(0), {1});
  const std::vector<std::uint32_t> label = nearest_labels(level);
  for (const Node& node : shapes::nodes_of(linked.lattice)) {
    const std::uint32_t side = label[static_cast<std::size_t>(linked.runs.node_at(node[0], node[1], node[2]))];
    ASSERT_NE(side, no_side);
    const glm::dvec3 away = glm::abs(shapes::place_of(linked.lattice, node));
    const double out = std::max({away.x, away.y, away.z});
    const bool is_outer = side / 2 < 12, is_front = side % 2 == 0;
    if (out > 1) {
      EXPECT_TRUE(is_outer && is_front);
    } else if (out < 0.5) {
      EXPECT_TRUE(!is_outer && !is_front);
    } else {
      EXPECT_EQ(is_front, !is_outer);
    }
  }
}

TEST(NearestLabels, ComeFromANodeAsFewLinksAwayAsAny) {
  const DiffusionSurfaces ball = shapes::sphere(0.3, 3);
  const shapes::LinkedShapes linked(ball, lattice_around(ball, 0.1, 5, 1, glm::dvec3(0.3)));
  const CutLinks links = linked.links();
  const GridLevel level = make_grid_level(linked.lattice, linked.runs, linked.links(), glm::dvec3(0), {1});
  const std::vector<std::uint32_t> label = nearest_labels(level);
  const std::vector<int> steps = steps_to_surface(linked, links);
  for (const Node& node : shapes::nodes_of(linked.lattice)) {
    const auto number = static_cast<std::size_t>(linked.runs.node_at(node[0], node[1], node[2]));
    ASSERT_GE(steps[number], 0);
    if (steps[number] == 0) {
      // Its own nearest cut.
      float nearest = 2;
      for (int d = 0; d < 6; ++d) {
        if (const LinkCut* cut = shapes::cut_of(links, static_cast<std::uint32_t>(number), d))
          nearest = std::min(nearest, cut->theta);
      }
      bool is_own = false;
      for (int d = 0; d < 6; ++d) {
        const LinkCut* cut = shapes::cut_of(links, static_cast<std::uint32_t>(number), d);
        is_own = is_own || (cut && cut->theta == nearest && cut->side == label[number]);
      }
      EXPECT_TRUE(is_own);
      continue;
    }
    bool has_giver = false;
    for (int d = 0; d < 6; ++d) {
      if (!linked.is_open(node, d)) continue;
      const Node other = shapes::beside(node, d);
      const auto there = static_cast<std::size_t>(linked.runs.node_at(other[0], other[1], other[2]));
      has_giver = has_giver || (steps[there] + 1 == steps[number] && label[there] == label[number]);
    }
    EXPECT_TRUE(has_giver);
  }
}

TEST(NearestLabels, AreNoneWithoutASurface) {
  const shapes::LinkedShapes linked(shapes::sphere(0.3, 2), shapes::whole_lattice());
  CutLinks links;
  links.open = linked.finder.open();
  for (std::uint32_t node = 0; node < links.open.size(); ++node) {
    if (links.open[node] != all_open && (links.open[node] & takes_no_part) == 0) links.node.push_back({node, 0, 0});
  }
  const GridLevel level = make_grid_level(linked.lattice, linked.runs, std::move(links), glm::dvec3(0), {1});
  for (const std::uint32_t side : nearest_labels(level)) EXPECT_EQ(side, no_side);
}

}  // namespace
}  // namespace pomona
