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

using shapes::GriddedShapes;

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

GridLevel level_of(const GriddedShapes& gridded) {
  return make_grid_level(gridded.lattice, gridded.blocks, gridded.arms(), glm::dvec3(0), {1});
}

/// Whether each arm of a node ends at a node or a surface.
bool has_all_arms(const GridLevel& level, const CutNode& node) {
  return ((level.arms.open[node.node] | node.cut) & all_open) == all_open;
}

Node node_of(const SparseBlocks& blocks, std::uint32_t number) {
  const NodeBlock& block = blocks[number / 8];
  return {8 * block.column + static_cast<int>(number % 8), block.y, block.z};
}

/// Second differences are exact for linear functions, for arms of any length.
TEST(GridLevel, HasEquationsThatLinearFieldsFulfil) {
  const GriddedShapes gridded(linear_room(), lattice_in(linear_room()));
  const GridLevel level = level_of(gridded);
  std::size_t asked = 0;
  for (std::size_t i = 0; i < level.arms.node.size(); ++i) {
    const CutNode& node = level.arms.node[i];
    if (!has_all_arms(level, node)) continue;
    ++asked;
    const Node at = node_of(level.blocks, node.node);
    const Stencil& stencil = level.stencil[i];
    double sum = stencil.source[0];
    double of_ones = stencil.source[3];
    for (int d = 0; d < 6; ++d) {
      const double weight = stencil.weight[static_cast<std::size_t>(d)];
      EXPECT_EQ(weight > 0, (level.arms.open[node.node] >> d & 1) != 0);
      sum += weight * linear(shapes::place_of(gridded.lattice, shapes::beside(at, d)));
      of_ones += weight;
    }
    EXPECT_NEAR(sum / static_cast<double>(stencil.diagonal), linear(shapes::place_of(gridded.lattice, at)), 1e-6);
    EXPECT_NEAR(of_ones / static_cast<double>(stencil.diagonal), 1, 1e-6);
    EXPECT_NEAR(stencil.inverse * stencil.diagonal, 1, 1e-6);
  }
  EXPECT_GT(asked, 300u);
}

TEST(GridLevel, FindsTheStencilsOfItsNodes) {
  const GriddedShapes gridded(linear_room(), lattice_in(linear_room()));
  const GridLevel level = level_of(gridded);
  ASSERT_EQ(level.stencil.size(), level.arms.node.size());
  for (std::size_t i = 0; i < level.arms.node.size(); ++i) {
    const std::uint32_t node = level.arms.node[i].node;
    EXPECT_EQ(level.stencil_of(node / 8, static_cast<int>(node % 8)), i);
    EXPECT_TRUE(level.block_arms[node / 8].irregular >> node % 8 & 1);
  }
  for (std::size_t r = 0; r < level.blocks.size(); ++r) {
    const BlockArms& block = level.block_arms[r];
    const NodeBlock& here = level.blocks[r];
    bool is_plain = true;
    for (std::size_t k = 0; k < 8; ++k) is_plain = is_plain && level.arms.open[8 * r + k] == all_open;
    EXPECT_EQ(block.plain != 0, is_plain);
    for (const auto& [offset, y, z] :
         {std::tuple{block.y_down, -1, 0}, {block.y_up, 1, 0}, {block.z_down, 0, -1}, {block.z_up, 0, 1}}) {
      const std::int32_t other = level.blocks.at(here.column, here.y + y, here.z + z);
      const std::int32_t own = static_cast<std::int32_t>(8 * r);
      EXPECT_EQ(own + offset, other == SparseBlocks::none ? own : 8 * other);
    }
  }
}

/// Beyond the border the field falls like 1 / r.
TEST(GridLevel, FallsLikeOneOverTheDistanceAtItsBorder) {
  const DiffusionSurfaces seed = shapes::sphere(0.05, 3);
  const GriddedShapes gridded(seed, lattice_around(seed, 0.1, 10, 0, glm::dvec3(0)));
  const GridLevel level = level_of(gridded);
  const auto potential = [&](const Node& node) { return 1 / glm::length(shapes::place_of(gridded.lattice, node)); };
  std::size_t asked = 0;
  for (std::size_t i = 0; i < level.arms.node.size(); ++i) {
    const CutNode& node = level.arms.node[i];
    const Node at = node_of(level.blocks, node.node);
    if (has_all_arms(level, node) || at[0] >= level.lattice.count[0] || node.cut != 0) continue;
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
  const GriddedShapes gridded(linear_room(), lattice_in(linear_room()));
  const GridLevel fine = level_of(gridded);
  const GridLevel coarse = coarser(fine, glm::dvec3(0), {1});
  EXPECT_EQ(coarse.lattice.spacing, 2 * fine.lattice.spacing);
  std::size_t cut = 0, open = 0;
  for (const Node& node : shapes::nodes_of(coarse.lattice)) {
    const auto number = static_cast<std::uint32_t>(coarse.blocks.node_at(node[0], node[1], node[2]));
    for (int d = 0; d < 6; ++d) {
      // The two halves of a coarse arm.
      const Node below{2 * node[0], 2 * node[1], 2 * node[2]}, middle = shapes::beside(below, d);
      const auto first = static_cast<std::uint32_t>(fine.blocks.node_at(below[0], below[1], below[2]));
      const std::int32_t second = fine.blocks.node_at(middle[0], middle[1], middle[2]);
      const bool first_open = fine.arms.open[first] >> d & 1;
      const bool both_open = first_open && (fine.arms.open[static_cast<std::size_t>(second)] >> d & 1);
      EXPECT_EQ((coarse.arms.open[number] >> d & 1) != 0, both_open);
      const ArmCut* own = shapes::cut_of(coarse.arms, number, d);
      const ArmCut* nearer = first_open ? shapes::cut_of(fine.arms, static_cast<std::uint32_t>(second), d)
                                        : shapes::cut_of(fine.arms, first, d);
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
  const GriddedShapes gridded(linear_room(), lattice_in(linear_room()));
  const GridLevel coarse = coarser(level_of(gridded), glm::dvec3(0), {1});
  ASSERT_EQ(coarse.rhs.size(), coarse.blocks.node_count());
  for (std::size_t i = 0; i < coarse.rhs.size(); ++i) {
    for (int lane = 0; lane < 4; ++lane) EXPECT_EQ(std::abs(coarse.rhs[i][lane]) + std::abs(coarse.value[i][lane]), 0);
  }
}

}  // namespace
}  // namespace pomona
