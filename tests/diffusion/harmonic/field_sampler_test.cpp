#include "generator/diffusion/harmonic/field_sampler.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/random.h"
#include "generator/diffusion/harmonic/nearest_labels.h"
#include "generator/diffusion/nearest_side.h"
#include "generator/mesh/triangle_distance.h"
#include "tests/diffusion/fields.h"
#include "tests/diffusion/harmonic/whole_cells.h"
#include "tests/diffusion/harmonic/whole_shapes.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

glm::dvec3 linear(const glm::dvec3& p) { return {0.5 + 0.02 * p.x, 0.5 - 0.03 * p.y + 0.01 * p.z, 0.4 + 0.02 * p.z}; }

/// A grid whose values are those of the linear field; all walks end on a surface.
SolvedGrid linear_grid(const Lattice& lattice) {
  SolvedGrid grid;
  grid.lattice = lattice;
  grid.blocks = all_blocks(lattice.count);
  grid.members = shapes::all_members(grid.blocks);
  grid.value = RawArray<Quad>(grid.blocks.node_count());
  for (const Node& node : shapes::nodes_of(lattice)) {
    const glm::vec3 color(linear(shapes::place_of(lattice, node)));
    const Quad value{color.r, color.g, color.b, 1};
    grid.value[static_cast<std::size_t>(grid.blocks.node_at(node[0], node[1], node[2]))] = value;
  }
  return grid;
}

struct Scene {
  explicit Scene(DiffusionSurfaces all) : surfaces(std::move(all)), snapped(pomona::snapped(surfaces, lattice)) {}

  FieldSampler sampler(std::vector<SolvedGrid> finer = {}) const {
    SolvedGrids grids;
    grids.grids = std::move(finer);
    grids.grids.push_back(linear_grid(lattice));
    grids.every_other = all_blocks(doubled(lattice).count);
    for (std::uint32_t node = 0; node < grids.every_other.node_count(); ++node) grids.label.push_back(node);
    return {snapped, std::move(grids), cell_triangles(snapped, lattice, 1e-4, {1})};
  }

  Lattice lattice = [] {
    Lattice whole = shapes::whole_lattice();
    whole.count = {17, 9, 9};
    return whole;
  }();
  DiffusionSurfaces surfaces;
  SnappedSurfaces snapped;
};

/// A ball of the linear field's colours on both sides.
DiffusionSurfaces linear_ball() {
  return fields::painted_with(shapes::moved(shapes::sphere(1.3, 4), {2.1, 2.2, 1.9}), linear);
}

std::vector<glm::vec3> points_in(const glm::dvec3& low, const glm::dvec3& high, int count) {
  const RandomStream random({}, "tests/points to look up");
  std::vector<glm::vec3> points;
  for (std::uint64_t n = 0; static_cast<int>(points.size()) < count; n += 3)
    points.emplace_back(low +
                        (high - low) * glm::dvec3(random.uniform(n), random.uniform(n + 1), random.uniform(n + 2)));
  return points;
}

TEST(FieldSampler, ReproducesLinearFieldsAwayFromSurfacesAndBesideThem) {
  const Scene scene(linear_ball());
  const FieldSampler sampler = scene.sampler();
  int beside = 0, away = 0;
  for (const glm::vec3& p : points_in(glm::dvec3(-1.9), {13.9, 5.9, 5.9}, 3000)) {
    const auto found = sampler.at(p);
    ASSERT_TRUE(found.has_value());
    // Beside a surface, small stiffness pulls towards the surface's colour: a tenth of 1/255 at most.
    const bool is_away = std::isinf(found->distance);
    EXPECT_LT(glm::distance(glm::dvec3(found->color), linear(glm::dvec3(p))), is_away ? 1e-6 : 4e-4);
    (is_away ? away : beside) += 1;
  }
  EXPECT_GT(beside, 100);
  EXPECT_GT(away, 1000);
}

/// The nearest place of all surfaces, one triangle after the other.
struct NearestPlace {
  double distance = std::numeric_limits<double>::infinity();
  glm::dvec3 place{0};
  bool sees_front = false;
};
NearestPlace nearest_place(const DiffusionSurfaces& surfaces, const glm::dvec3& p) {
  NearestPlace nearest;
  for (const glm::uvec3& t : surfaces.triangle) {
    const glm::dvec3 a(surfaces.position[t.x]), b(surfaces.position[t.y]), c(surfaces.position[t.z]);
    const glm::dvec3 weight = nearest_weights(p, a, b, c);
    const glm::dvec3 place = weight.x * a + weight.y * b + weight.z * c;
    if (glm::distance(place, p) >= nearest.distance) continue;
    nearest = {glm::distance(place, p), place, glm::dot(glm::cross(b - a, c - a), p - a) > 0};
  }
  return nearest;
}

TEST(FieldSampler, KnowsHowFarTheNearestSurfaceInItsCellIsAndWhichSideItSees) {
  const Scene scene(linear_ball());
  const FieldSampler sampler = scene.sampler();
  int asked = 0;
  for (const glm::vec3& p : points_in(glm::dvec3(0.6), glm::dvec3(3.8), 1000)) {
    const auto found = sampler.at(p);
    ASSERT_TRUE(found.has_value() && found->side.has_value());
    const NearestPlace nearest = nearest_place(scene.surfaces, glm::dvec3(p));
    EXPECT_GT(found->distance, nearest.distance - 1e-5);
    if (glm::floor(nearest.place) != glm::floor(glm::dvec3(p)) || nearest.distance < 1e-4) continue;
    ++asked;
    EXPECT_NEAR(found->distance, nearest.distance, 1e-5);
    EXPECT_EQ(*found->side % 2 == 0, nearest.sees_front);
  }
  EXPECT_GT(asked, 200);
}

TEST(FieldSampler, LooksNotThroughASurface) {
  // The grid's values are wrong inside a box that fills one cell; there only the colours of its walls count.
  shapes::Paint paint;
  paint.back = Color(0.9f, 0.1f, 0.2f);
  paint.front = Color(0.3f, 0.3f, 0.3f);
  const Scene scene(shapes::box({1.05, 1.05, 1.05}, {1.95, 1.95, 1.95}, 1, paint));
  const FieldSampler sampler = scene.sampler();
  for (const glm::vec3& p : points_in(glm::dvec3(1.06), glm::dvec3(1.94), 500)) {
    const auto found = sampler.at(p);
    ASSERT_TRUE(found.has_value());
    EXPECT_LT(glm::distance(found->color, paint.back), 1e-4f);
    EXPECT_EQ(*found->side % 2, 1u);
  }
}

TEST(FieldSampler, HasNothingOutsideItsGrid) {
  const Scene scene(linear_ball());
  const FieldSampler sampler = scene.sampler();
  for (const glm::vec3& p : {glm::vec3(-2.1f, 2, 2), {2, 6.01f, 2}, {2, 2, 1e9f}, {14.1f, 0, 0}})
    EXPECT_FALSE(sampler.at(p));
  EXPECT_TRUE(sampler.at({13.99f, 5.99f, 5.99f}));
}

TEST(FieldSampler, NamesTheLabelOfTheEvenCornerOfACell) {
  const Scene scene(linear_ball());
  const FieldSampler sampler = scene.sampler();
  const SparseBlocks every_other = all_blocks(doubled(scene.lattice).count);
  for (const glm::vec3& p : points_in({5, -1.9, -1.9}, {13.9, 5.9, 5.9}, 200)) {
    const auto found = sampler.at(p);
    ASSERT_TRUE(found && found->side);
    // In this test labels are the numbers of nodes. Nodes with even coordinates lie at even metres.
    const NodeBlock& block = every_other[*found->side / 8];
    const glm::dvec3 node(-2 + 2 * (8 * block.column + static_cast<int>(*found->side % 8)), -2 + 2 * block.y,
                          -2 + 2 * block.z);
    for (int k = 0; k < 3; ++k) EXPECT_LE(std::fabs(node[k] - static_cast<double>(p[k])), 1);
  }
}

TEST(FieldSampler, TakesTheFinestPatchThatHasTheWholeCell) {
  const Scene scene(linear_ball());
  SolvedGrid patch = linear_grid(halved(scene.lattice));
  std::fill(patch.value.data(), patch.value.data() + patch.value.size(), Quad{0.1f, 0.2f, 0.3f, 1});
  // Only cells with x from 8 m to 12 m: nodes 20 to 28.
  for (std::size_t r = 0; r < patch.blocks.size(); ++r) {
    std::uint8_t bits = 0;
    for (int k = 0; k < 8; ++k) {
      const int x = 8 * patch.blocks[r].column + k;
      if (x >= 20 && x <= 28) bits = static_cast<std::uint8_t>(bits | 1 << k);
    }
    patch.members[r] = bits;
  }
  std::vector<SolvedGrid> finer;
  finer.push_back(std::move(patch));
  const FieldSampler sampler = scene.sampler(std::move(finer));
  for (const glm::vec3& p : points_in({6, -1.9, -1.9}, {13.9, 5.9, 5.9}, 500)) {
    const bool is_in_patch = p.x >= 8 && p.x < 12;
    const glm::dvec3 wanted = is_in_patch ? glm::dvec3(0.1, 0.2, 0.3) : linear(glm::dvec3(p));
    EXPECT_LT(glm::distance(glm::dvec3(sampler.at(p)->color), wanted), 2e-5) << p.x;
  }
}

TEST(FieldSampler, HasNoColourWhereNoWalkEnds) {
  const Scene scene(linear_ball());
  SolvedGrids grids;
  grids.grids.push_back(linear_grid(scene.lattice));
  SolvedGrid& grid = grids.grids.back();
  std::fill(grid.value.data(), grid.value.data() + grid.value.size(), Quad{});
  grids.every_other = all_blocks(doubled(scene.lattice).count);
  grids.label.assign(grids.every_other.node_count(), no_side);
  const FieldSampler sampler(scene.snapped, std::move(grids), cell_triangles(scene.snapped, scene.lattice, 1e-4, {1}));
  EXPECT_FALSE(sampler.at({10, 1.5f, 1.5f}));
  EXPECT_TRUE(sampler.at({2.1f, 2.2f, 3.1f})) << "a surface is in sight";
}

}  // namespace
}  // namespace pomona
