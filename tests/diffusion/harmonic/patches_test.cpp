#include "generator/diffusion/harmonic/patches.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/diffusion/harmonic/crossings.h"
#include "tests/diffusion/harmonic/whole_shapes.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

/// A large ball, a seed and a leaf.
DiffusionSurfaces ball_with_seed_and_leaf() {
  return joined(joined(shapes::sphere(1, 4), shapes::moved(shapes::sphere(0.05, 6), {0.3, 0.2, 0.1})),
                shapes::moved(shapes::open_sheet(0.08, 0, 1), {-0.4, 0, 0}));
}

TEST(Patches, FindSmallBodiesAndHowThickTheyAre) {
  const std::vector<SmallBody> bodies = small_bodies(ball_with_seed_and_leaf(), 0.3);
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_EQ(bodies[0].triangle.size(), 8u * 36);
  EXPECT_EQ(bodies[0].triangle.front(), 8u * 16) << "the large ball's come first";
  EXPECT_NEAR(bodies[0].half_thickness, 0.05, 0.05 * 0.03) << "the radius of a ball";
  EXPECT_EQ(bodies[1].triangle.size(), 2u);
  EXPECT_EQ(bodies[1].half_thickness, 0);
  EXPECT_EQ(small_bodies(ball_with_seed_and_leaf(), 10).size(), 3u);
}

TEST(Patches, MeasureThicknessAnywhereAndInsideOut) {
  const DiffusionSurfaces far = shapes::moved(shapes::sphere(0.05, 6), {10, 20, -7});
  EXPECT_NEAR(small_bodies(far, 1)[0].half_thickness, 0.05, 0.05 * 0.03);
  EXPECT_NEAR(small_bodies(shapes::turned_inside_out(far), 1)[0].half_thickness, 0.05, 0.05 * 0.03);
}

struct Scene {
  DiffusionSurfaces surfaces = ball_with_seed_and_leaf();
  Lattice lattice = lattice_around(surfaces, 0.1, 1, 4, glm::dvec3(0.2));
  SnappedSurfaces snapped = pomona::snapped(surfaces, lattice);
  std::vector<std::uint32_t> seed = small_bodies(surfaces, 0.3)[0].triangle;
};

bool is_member(const PatchNodes& patch, const Node& node) {
  const std::int32_t number = patch.blocks.node_at(node[0], node[1], node[2]);
  if (number == SparseBlocks::none) return false;
  return patch.members[static_cast<std::size_t>(number) / 8] >> number % 8 & 1;
}

/// Patches consist of whole bricks: a node inside the patch has its 8 neighbours in a brick there.
TEST(Patches, CoverTheirBodiesWithAMargin) {
  const Scene scene;
  const PatchNodes patch = patch_around(scene.snapped, scene.seed, scene.lattice, 1, nullptr);
  const Lattice fine = halved(scene.lattice);
  std::size_t members = 0;
  for (const Node& node : shapes::nodes_of(fine)) {
    const glm::dvec3 from_seed = glm::abs(shapes::place_of(fine, node) - glm::dvec3(0.3, 0.2, 0.1));
    const double away = std::max({from_seed.x, from_seed.y, from_seed.z});
    if (away < 0.05 + 0.1 - 0.002) {
      EXPECT_TRUE(is_member(patch, node)) << away;
    }
    // A brick is four cells long.
    if (away > 0.05 + 0.1 + 0.4 + 0.002) {
      EXPECT_FALSE(is_member(patch, node)) << away;
    }
    members += is_member(patch, node) ? 1 : 0;
  }
  EXPECT_GT(members, 300u);
}

TEST(Patches, ConsistOfWholeBricks) {
  const Scene scene;
  const PatchNodes patch = patch_around(scene.snapped, scene.seed, scene.lattice, 1, nullptr);
  const Lattice fine = halved(scene.lattice);
  const Node bricks{(scene.lattice.count[0] - 1) / 4, (scene.lattice.count[1] - 1) / 2,
                    (scene.lattice.count[2] - 1) / 2};
  std::vector<std::uint8_t> wanted(shapes::nodes_of(fine).size(), 0);
  const auto index = [&](int x, int y, int z) {
    return static_cast<std::size_t>((z * fine.count[1] + y) * fine.count[0] + x);
  };
  ASSERT_EQ(patch.is_covered.size(), static_cast<std::size_t>(bricks[0] * bricks[1] * bricks[2]));
  for (std::size_t b = 0; b < patch.is_covered.size(); ++b) {
    if (!patch.is_covered[b]) continue;
    const int number = static_cast<int>(b);
    const Node at{number % bricks[0], number / bricks[0] % bricks[1], number / bricks[0] / bricks[1]};
    for (int z = 0; z <= 4; ++z) {
      for (int y = 0; y <= 4; ++y) {
        for (int x = 0; x <= 8; ++x) wanted[index(8 * at[0] + x, 4 * at[1] + y, 4 * at[2] + z)] = 1;
      }
    }
  }
  for (const Node& node : shapes::nodes_of(fine))
    EXPECT_EQ(is_member(patch, node), wanted[index(node[0], node[1], node[2])] != 0);
}

TEST(Patches, KnowAllTrianglesThatMeetThem) {
  const Scene scene;
  const PatchNodes patch = patch_around(scene.snapped, scene.seed, scene.lattice, 1, nullptr);
  EXPECT_TRUE(std::is_sorted(patch.triangle.begin(), patch.triangle.end()));
  EXPECT_TRUE(std::includes(patch.triangle.begin(), patch.triangle.end(), scene.seed.begin(), scene.seed.end()));
  const std::vector<std::uint32_t> all = shapes::all_triangles(scene.surfaces);
  const Lattice fine = halved(scene.lattice);
  SnappedSurfaces snapped_fine = pomona::snapped(scene.surfaces, fine);
  for (const ArmCrossing& c : arm_crossings(snapped_fine, all, fine, 0, fine.count[2])) {
    if (!is_member(patch, c.node)) continue;
    EXPECT_TRUE(std::binary_search(patch.triangle.begin(), patch.triangle.end(), c.triangle));
  }
}

TEST(Patches, StayWithinThoseAroundThem) {
  const Scene scene;
  const PatchNodes outer = patch_around(scene.snapped, scene.seed, scene.lattice, 1, nullptr);
  const Lattice fine = halved(scene.lattice);
  // A margin that would reach far out of the lattice.
  const PatchNodes inner = patch_around(pomona::snapped(scene.surfaces, fine), scene.seed, fine, 9, &outer);
  std::size_t members = 0;
  for (const Node& node : shapes::nodes_of(halved(fine))) {
    if (!is_member(inner, node)) continue;
    ++members;
    if (node[0] % 2 == 0 && node[1] % 2 == 0 && node[2] % 2 == 0) {
      EXPECT_TRUE(is_member(outer, {node[0] / 2, node[1] / 2, node[2] / 2}));
    }
  }
  EXPECT_GT(members, 1000u);
}

}  // namespace
}  // namespace pomona
