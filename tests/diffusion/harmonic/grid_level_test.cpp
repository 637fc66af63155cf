#include "generator/diffusion/harmonic/grid_level.h"

#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/diffusion/fields.h"
#include "tests/diffusion/harmonic/whole_shapes.h"

namespace pomona {
namespace {

using shapes::LinkedShapes;

double linear(const glm::dvec3& p) { return 0.4 + 0.1 * p.x - 0.05 * p.y + 0.07 * p.z; }

/// A ball in a box, both painted with the linear function.
DiffusionSurfaces linear_room() {
  const DiffusionSurfaces room =
      joined(shapes::tilted(shapes::box({-1, -1, -1}, {1, 1, 1}, 3)), shapes::sphere(0.4, 6));
  return fields::painted_with(room, [](const glm::dvec3& p) { return glm::dvec3(linear(p)); });
}

Lattice lattice_in(const DiffusionSurfaces& surfaces) {
  return lattice_around(surfaces, 0.2, 1, 4, glm::dvec3(0.1, 0.4, 0.8));
}

GridLevel level_of(const LinkedShapes& linked) {
  return make_grid_level(linked.lattice, linked.runs, linked.links(), glm::dvec3(0), {1});
}

/// Whether no link of a node leads to nowhere.
bool has_all_links(const GridLevel& level, const CutNode& node) {
  return ((level.links.open[node.node] | node.cut) & all_open) == all_open;
}

Node node_of(const NodeRuns& runs, std::uint32_t number) {
  const NodeRun& run = runs[number / 8];
  return {8 * run.block + static_cast<int>(number % 8), run.y, run.z};
}

/// Second differences over links of any length are exact for linear functions.
TEST(GridLevel, HasEquationsThatLinearFieldsFulfil) {
  const LinkedShapes linked(linear_room(), lattice_in(linear_room()));
  const GridLevel level = level_of(linked);
  std::size_t asked = 0;
  for (std::size_t i = 0; i < level.links.node.size(); ++i) {
    const CutNode& node = level.links.node[i];
    if (!has_all_links(level, node)) continue;
    ++asked;
    const Node at = node_of(level.runs, node.node);
    const Stencil& stencil = level.stencil[i];
    double sum = stencil.source[0];
    double of_ones = stencil.source[3];
    for (int d = 0; d < 6; ++d) {
      const double weight = stencil.weight[static_cast<std::size_t>(d)];
      EXPECT_EQ(weight > 0, (level.links.open[node.node] >> d & 1) != 0);
      sum += weight * linear(shapes::place_of(linked.lattice, shapes::beside(at, d)));
      of_ones += weight;
    }
    EXPECT_NEAR(sum / static_cast<double>(stencil.diagonal), linear(shapes::place_of(linked.lattice, at)), 1e-6);
    EXPECT_NEAR(of_ones / static_cast<double>(stencil.diagonal), 1, 1e-6);
    EXPECT_NEAR(stencil.inverse * stencil.diagonal, 1, 1e-6);
  }
  EXPECT_GT(asked, 300u);
}

TEST(GridLevel, FindsTheStencilsOfItsNodes) {
  const LinkedShapes linked(linear_room(), lattice_in(linear_room()));
  const GridLevel level = level_of(linked);
  ASSERT_EQ(level.stencil.size(), level.links.node.size());
  for (std::size_t i = 0; i < level.links.node.size(); ++i) {
    const std::uint32_t node = level.links.node[i].node;
    EXPECT_EQ(level.stencil_of(node / 8, static_cast<int>(node % 8)), i);
    EXPECT_TRUE(level.run_links[node / 8].irregular >> node % 8 & 1);
  }
  for (std::size_t r = 0; r < level.runs.size(); ++r) {
    const RunLinks& run = level.run_links[r];
    const NodeRun& here = level.runs[r];
    bool is_plain = true;
    for (std::size_t k = 0; k < 8; ++k) is_plain = is_plain && level.links.open[8 * r + k] == all_open;
    EXPECT_EQ(run.plain != 0, is_plain);
    for (const auto& [offset, y, z] :
         {std::tuple{run.y_down, -1, 0}, {run.y_up, 1, 0}, {run.z_down, 0, -1}, {run.z_up, 0, 1}}) {
      const std::int32_t other = level.runs.at(here.block, here.y + y, here.z + z);
      const std::int32_t own = static_cast<std::int32_t>(8 * r);
      EXPECT_EQ(own + offset, other == NodeRuns::none ? own : 8 * other);
    }
  }
}

/// Beyond the border a field goes on falling like 1 / r.
TEST(GridLevel, FallsLikeOneOverTheDistanceAtItsBorder) {
  const DiffusionSurfaces seed = shapes::sphere(0.05, 3);
  const LinkedShapes linked(seed, lattice_around(seed, 0.1, 10, 0, glm::dvec3(0)));
  const GridLevel level = level_of(linked);
  const auto potential = [&](const Node& node) { return 1 / glm::length(shapes::place_of(linked.lattice, node)); };
  std::size_t asked = 0;
  for (std::size_t i = 0; i < level.links.node.size(); ++i) {
    const CutNode& node = level.links.node[i];
    const Node at = node_of(level.runs, node.node);
    if (has_all_links(level, node) || at[0] >= level.lattice.count[0] || node.cut != 0) continue;
    ++asked;
    double sum = 0;
    for (int d = 0; d < 6; ++d)
      sum +=
          static_cast<double>(level.stencil[i].weight[static_cast<std::size_t>(d)]) * potential(shapes::beside(at, d));
    const double found = sum / static_cast<double>(level.stencil[i].diagonal);
    EXPECT_NEAR(found / potential(at), 1, 0.01);
  }
  EXPECT_GT(asked, 500u);
}

TEST(GridLevel, KeepsEveryOtherNodeWhenCoarser) {
  const LinkedShapes linked(linear_room(), lattice_in(linear_room()));
  const GridLevel fine = level_of(linked);
  const GridLevel coarse = coarser(fine, glm::dvec3(0), {1});
  EXPECT_EQ(coarse.lattice.spacing, 2 * fine.lattice.spacing);
  std::size_t cut = 0, open = 0;
  for (const Node& node : shapes::nodes_of(coarse.lattice)) {
    const auto number = static_cast<std::uint32_t>(coarse.runs.node_at(node[0], node[1], node[2]));
    for (int d = 0; d < 6; ++d) {
      // The two halves of a coarse link.
      const Node below{2 * node[0], 2 * node[1], 2 * node[2]}, middle = shapes::beside(below, d);
      const auto first = static_cast<std::uint32_t>(fine.runs.node_at(below[0], below[1], below[2]));
      const std::int32_t second = fine.runs.node_at(middle[0], middle[1], middle[2]);
      const bool first_open = fine.links.open[first] >> d & 1;
      const bool both_open = first_open && (fine.links.open[static_cast<std::size_t>(second)] >> d & 1);
      EXPECT_EQ((coarse.links.open[number] >> d & 1) != 0, both_open);
      const LinkCut* own = shapes::cut_of(coarse.links, number, d);
      const LinkCut* nearer = first_open ? shapes::cut_of(fine.links, static_cast<std::uint32_t>(second), d)
                                         : shapes::cut_of(fine.links, first, d);
      ASSERT_EQ(own != nullptr, !both_open && nearer != nullptr);
      open += both_open ? 1 : 0;
      if (own == nullptr) continue;
      ++cut;
      EXPECT_FLOAT_EQ(own->theta, (first_open ? 0.5f : 0) + nearer->theta / 2);
      EXPECT_EQ(own->side, nearer->side);
      EXPECT_EQ(own->color, nearer->color);
    }
  }
  EXPECT_GT(cut, 100u);
  EXPECT_GT(open, 100u);
}

TEST(GridLevel, BeginsWithZeros) {
  const LinkedShapes linked(linear_room(), lattice_in(linear_room()));
  const GridLevel coarse = coarser(level_of(linked), glm::dvec3(0), {1});
  ASSERT_EQ(coarse.rhs.size(), coarse.runs.node_count());
  for (std::size_t i = 0; i < coarse.rhs.size(); ++i) {
    for (int lane = 0; lane < 4; ++lane) EXPECT_EQ(std::abs(coarse.rhs[i][lane]) + std::abs(coarse.value[i][lane]), 0);
  }
}

}  // namespace
}  // namespace pomona
