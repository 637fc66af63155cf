#include "generator/diffusion/harmonic/solve_field.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/diffusion/fields.h"
#include "tests/diffusion/harmonic/whole_shapes.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

GridOptions options_of(double spacing, int finer = 0) {
  return {.spacing = spacing,
          .cycles = 8,
          .shift = glm::dvec3(0.3, 0.1, 0.7),
          .finer = finer,
          .reach = 1e-5,
          .threads = {2}};
}

bool takes_part(const GridLevel& level, const Node& node) {
  const std::int32_t number = level.blocks.node_at(node[0], node[1], node[2]);
  return number != SparseBlocks::none && (level.arms.open[static_cast<std::size_t>(number)] & takes_no_part) == 0;
}

const GridLevel& whole(const PreparedField& field) { return field.levels.front(); }

SolvedLevels levels_of(const DiffusionSurfaces& surfaces, const GridOptions& options) {
  PreparedField prepared = prepared_field(surfaces, options);
  return solved_levels(prepared.snapped, std::move(prepared.levels), options);
}

TEST(SolveField, LeavesOutTheAirAroundClosedSurfaces) {
  const DiffusionSurfaces ball = shapes::sphere(1, 6);
  for (const DiffusionSurfaces& surfaces : {ball, shapes::nested_spheres(1, 0.5, 6), shapes::hollow_ball(1, 0.5, 6)}) {
    const PreparedField field = prepared_field(surfaces, options_of(0.1));
    EXPECT_TRUE(field.is_sealed);
    for (const Node& node : shapes::nodes_of(whole(field).lattice)) {
      const double out = glm::length(shapes::place_of(whole(field).lattice, node));
      if (out > 1 || out < 0.97) {
        EXPECT_EQ(takes_part(whole(field), node), out < 1);
      }
    }
  }
}

TEST(SolveField, KeepsTheAirAroundOpenSurfacesAndMoreOfIt) {
  const DiffusionSurfaces sheet = shapes::open_sheet(1, 0, 3);
  DiffusionSurfaces bowl = shapes::sphere(0.5, 4);
  bowl.triangle.resize(bowl.triangle.size() - 20);
  bowl.surface.resize(bowl.triangle.size());
  bowl.front_part.resize(bowl.triangle.size());
  bowl.back_part.resize(bowl.triangle.size());
  for (const DiffusionSurfaces& surfaces : {sheet, bowl}) {
    const PreparedField field = prepared_field(surfaces, options_of(0.05));
    EXPECT_FALSE(field.is_sealed);
    const Lattice& lattice = whole(field).lattice;
    for (const Node& node : shapes::nodes_of(lattice)) EXPECT_TRUE(takes_part(whole(field), node));
    const Box<double> bounds = bounds_of(surfaces);
    for (int axis = 0; axis < 3; ++axis) EXPECT_LT(lattice.origin[axis], bounds.low[axis] - 0.24 * 1) << axis;
  }
}

TEST(SolveField, HalvesTheGridFourTimes) {
  const PreparedField field = prepared_field(shapes::sphere(1, 6), options_of(0.1));
  ASSERT_EQ(field.levels.size(), 5u);
  for (std::size_t l = 1; l < field.levels.size(); ++l) {
    EXPECT_EQ(field.levels[l].lattice.spacing, 2 * field.levels[l - 1].lattice.spacing);
    EXPECT_EQ(field.levels[l].rhs.size(), field.levels[l].blocks.node_count());
  }
  EXPECT_NEAR(whole(field).lattice.spacing, 0.1, 1e-15);
}

TEST(SolveField, PutsPatchesAroundSeedsThatAreSmallForTheGrid) {
  const auto with_seed = [](double radius) {
    return joined(shapes::sphere(1, 6), shapes::moved(shapes::sphere(radius, 4), {0.2, 0.1, 0.3}));
  };
  // At most as many patches as asked for, and only while the seed is thinner than 1.2 cells.
  EXPECT_EQ(levels_of(with_seed(0.03), options_of(0.1, 2)).patch_count, 2u);
  EXPECT_EQ(levels_of(with_seed(0.03), options_of(0.1, 1)).patch_count, 1u);
  EXPECT_EQ(levels_of(with_seed(0.03), options_of(0.1, 0)).patch_count, 0u);
  EXPECT_EQ(levels_of(with_seed(0.09), options_of(0.1, 2)).patch_count, 1u);
  EXPECT_EQ(levels_of(with_seed(0.2), options_of(0.1, 2)).patch_count, 0u);

  const SolvedLevels field = levels_of(with_seed(0.03), options_of(0.1, 2));
  EXPECT_EQ(field.levels[0].lattice.spacing, field.levels[2].lattice.spacing / 4);
  EXPECT_TRUE(field.levels[0].is_patch && field.levels[1].is_patch && !field.levels[2].is_patch);
  // Nodes on a patch's border take their values from the grid around it.
  for (const std::size_t l : {0u, 1u}) {
    std::size_t given = 0, own = 0;
    for (const std::uint8_t open : field.levels[l].arms.open) {
      if (open & takes_no_part) continue;
      (open & is_given ? given : own) += 1;
    }
    EXPECT_GT(given, 50u);
    EXPECT_GT(own, given / 2);
  }
}

/// A grid is limited only along x, by the length of a row. A long fruit extends along z.
TEST(SolveField, PutsPatchesIntoWhatIsLong) {
  const auto patches_in = [](const glm::dvec3& size) {
    const DiffusionSurfaces body = joined(shapes::box(-size, size), shapes::sphere(0.003, 4));
    return levels_of(body, options_of(0.01, 2)).patch_count;
  };
  EXPECT_EQ(patches_in({0.05, 0.05, 2}), 2u);
  EXPECT_EQ(patches_in({0.05, 2, 0.05}), 2u);
  EXPECT_EQ(patches_in({2, 0.05, 0.05}), 1u) << "1601 nodes are too many";
}

/// A large ball with a smaller one in its middle, neither small for the grid: the solution bends only at the inner one.
TEST(SolveField, PutsPatchesWhereTheSolutionBends) {
  const DiffusionSurfaces balls = shapes::nested_spheres(1, 0.2, 8);
  GridOptions options = options_of(0.06, 2);
  EXPECT_EQ(levels_of(balls, options).patch_count, 0u) << "unless asked";
  options.refine_above = 8.0 / 255;
  const SolvedLevels bent = levels_of(balls, options);
  ASSERT_GT(bent.patch_count, 0u);
  for (std::size_t l = 0; l < bent.patch_count; ++l) {
    const GridLevel& patch = bent.levels[l];
    std::size_t members = 0;
    for (const Node& node : shapes::nodes_of(patch.lattice)) {
      if (!takes_part(patch, node)) continue;
      ++members;
      EXPECT_LT(glm::length(shapes::place_of(patch.lattice, node)), 0.7);
    }
    EXPECT_GT(members, 200u);
  }
  options.refine_above = 0.6;
  EXPECT_EQ(levels_of(balls, options).patch_count, 0u) << "nothing bends as much as that";
}

TEST(SolveField, KeepsEachPatchWithinItsNodes) {
  const DiffusionSurfaces balls = shapes::nested_spheres(1, 0.2, 8);
  GridOptions options = options_of(0.06, 2);
  options.refine_above = 2.0 / 255;
  const auto nodes_of_patches = [&](std::size_t max) {
    options.max_patch_nodes = max;
    const SolvedLevels levels = levels_of(balls, options);
    std::size_t nodes = 0;
    for (std::size_t l = 0; l < levels.patch_count; ++l) {
      EXPECT_LE(levels.levels[l].blocks.node_count(), max);
      nodes += levels.levels[l].blocks.node_count();
    }
    return nodes;
  };
  const std::size_t few = nodes_of_patches(10'000), many = nodes_of_patches(1'000'000);
  EXPECT_GT(few, 3000u) << "the most bent are there all the same";
  EXPECT_GT(many, 2 * few);
}

/// Between a white ball and a black one around it the field is (1 / r - 1) / (1 / inner - 1). \returns the max
/// difference of a solved field from that, near the inner ball.
double worst_beside_ball(const GridOptions& options) {
  constexpr double inner = 0.12;
  shapes::Paint black, white;
  black.front = black.back = Color(0);
  white.front = white.back = Color(1);
  const DiffusionSurfaces balls = shapes::nested_spheres(1, inner, 24, black, white);
  const FieldSampler sampler = solved_field(prepared_field(balls, options), options);
  double max = 0;
  for (int i = 0; i < 2000; ++i) {
    // Along a spiral that leaves the ball.
    const double r = inner + 0.005 + 0.00014 * i, z = -1 + (i * 37 % 400 + 0.5) / 200, flat = std::sqrt(1 - z * z);
    const glm::dvec3 place = r * glm::dvec3(flat * std::cos(2.4 * i), flat * std::sin(2.4 * i), z);
    const auto found = sampler.at(glm::vec3(place));
    if (!found) return 1.0;
    max = std::max(max, std::fabs(found->color.r - (1 / r - 1) / (1 / inner - 1)));
  }
  return max;
}

TEST(SolveField, IsNearerToTheTruthWithPatchesWhereItBends) {
  GridOptions options = options_of(0.06, 2);
  const double without = worst_beside_ball(options);
  options.refine_above = 4.0 / 255;
  const double with = worst_beside_ball(options);
  EXPECT_LT(with, 0.5 * without);
  EXPECT_LT(with, 2.5 / 255);
}

/// If only the most bent bricks are refined, patches end on the ball's surface. A border's node there takes a value
/// between the surface's and that of the node beside it.
TEST(SolveField, LosesNothingWherePatchesEndBesideSurfaces) {
  GridOptions options = options_of(0.06, 1);
  const double without = worst_beside_ball(options);
  for (const int bend : {40, 30, 24, 20, 16}) {
    options.refine_above = bend / 255.0;
    EXPECT_LT(worst_beside_ball(options), 1.25 * without) << bend;
  }
}

TEST(SolveField, ReproducesLinearColours) {
  const DiffusionSurfaces scene = shapes::tilted(fields::linear_scene());
  const auto linear = [](const glm::dvec3& p) { return glm::dvec3(0.5 + 0.2 * p.x, 0.5 - 0.1 * p.y + 0.1 * p.z, 0.4); };
  const DiffusionSurfaces painted = fields::painted_with(scene, linear);
  const FieldSampler sampler = solved_field(prepared_field(painted, options_of(0.12)), options_of(0.12));
  for (const glm::vec3& p : fields::points_in_linear_scene()) {
    const glm::vec3 inside = 0.57f * p;
    const auto found = sampler.at(inside);
    ASSERT_TRUE(found && found->side);
    EXPECT_LT(glm::distance(glm::dvec3(found->color), linear(glm::dvec3(inside))), 2e-5);
  }
}

}  // namespace
}  // namespace pomona
