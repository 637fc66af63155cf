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

/// For each node, the number of arms to the nearest node that has an arm to a surface.
std::vector<int> steps_to_surface(const shapes::GriddedShapes& gridded, const CutArms& arms) {
  std::vector<int> steps(gridded.blocks.node_count(), -1);
  std::deque<Node> waiting;
  const auto number_of = [&](const Node& n) {
    return static_cast<std::size_t>(gridded.blocks.node_at(n[0], n[1], n[2]));
  };
  for (const Node& node : shapes::nodes_of(gridded.lattice)) {
    const auto of =
        std::find_if(arms.node.begin(), arms.node.end(), [&](const CutNode& c) { return c.node == number_of(node); });
    if (of == arms.node.end() || of->cut == 0) continue;
    steps[number_of(node)] = 0;
    waiting.push_back(node);
  }
  for (; !waiting.empty(); waiting.pop_front()) {
    const Node node = waiting.front();
    for (int d = 0; d < 6; ++d) {
      if (!gridded.is_open(node, d)) continue;
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
  const shapes::GriddedShapes gridded(boxes, lattice_around(boxes, 0.13, 1, 2, glm::dvec3(0.3)));
  const GridLevel level = make_grid_level(gridded.lattice, gridded.blocks, gridded.arms(), glm::dvec3(0), {1});
  const std::vector<std::uint32_t> label = nearest_labels(level);
  for (const Node& node : shapes::nodes_of(gridded.lattice)) {
    const std::uint32_t side = label[static_cast<std::size_t>(gridded.blocks.node_at(node[0], node[1], node[2]))];
    ASSERT_NE(side, no_side);
    const glm::dvec3 away = glm::abs(shapes::place_of(gridded.lattice, node));
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

TEST(NearestLabels, ComeFromANodeAsFewArmsAwayAsAny) {
  const DiffusionSurfaces ball = shapes::sphere(0.3, 3);
  const shapes::GriddedShapes gridded(ball, lattice_around(ball, 0.1, 5, 1, glm::dvec3(0.3)));
  const CutArms arms = gridded.arms();
  const GridLevel level = make_grid_level(gridded.lattice, gridded.blocks, gridded.arms(), glm::dvec3(0), {1});
  const std::vector<std::uint32_t> label = nearest_labels(level);
  const std::vector<int> steps = steps_to_surface(gridded, arms);
  for (const Node& node : shapes::nodes_of(gridded.lattice)) {
    const auto number = static_cast<std::size_t>(gridded.blocks.node_at(node[0], node[1], node[2]));
    ASSERT_GE(steps[number], 0);
    if (steps[number] == 0) {
      // Its own nearest cut.
      float nearest = 2;
      for (int d = 0; d < 6; ++d) {
        if (const ArmCut* cut = shapes::cut_of(arms, static_cast<std::uint32_t>(number), d))
          nearest = std::min(nearest, cut->theta);
      }
      bool is_own = false;
      for (int d = 0; d < 6; ++d) {
        const ArmCut* cut = shapes::cut_of(arms, static_cast<std::uint32_t>(number), d);
        is_own = is_own || (cut && cut->theta == nearest && cut->side == label[number]);
      }
      EXPECT_TRUE(is_own);
      continue;
    }
    bool has_giver = false;
    for (int d = 0; d < 6; ++d) {
      if (!gridded.is_open(node, d)) continue;
      const Node other = shapes::beside(node, d);
      const auto there = static_cast<std::size_t>(gridded.blocks.node_at(other[0], other[1], other[2]));
      has_giver = has_giver || (steps[there] + 1 == steps[number] && label[there] == label[number]);
    }
    EXPECT_TRUE(has_giver);
  }
}

TEST(NearestLabels, AreNoneWithoutASurface) {
  const shapes::GriddedShapes gridded(shapes::sphere(0.3, 2), shapes::whole_lattice());
  CutArms arms;
  arms.open = gridded.finder.open();
  for (std::uint32_t node = 0; node < arms.open.size(); ++node) {
    if (arms.open[node] != all_open && (arms.open[node] & takes_no_part) == 0) arms.node.push_back({node, 0, 0});
  }
  const GridLevel level = make_grid_level(gridded.lattice, gridded.blocks, std::move(arms), glm::dvec3(0), {1});
  for (const std::uint32_t side : nearest_labels(level)) EXPECT_EQ(side, no_side);
}

}  // namespace
}  // namespace pomona
