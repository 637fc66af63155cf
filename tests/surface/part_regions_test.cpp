#include "generator/surface/part_regions.h"

#include <utility>

#include <gtest/gtest.h>

#include "generator/base/random.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

using namespace shapes;

TEST(PartRegions, AreTheRoomsThatSurfacesEncloseTheSmallestFirst) {
  Paint stone;
  stone.name = "stone", stone.front_part = "flesh", stone.back_part = "stone";
  const DiffusionSurfaces skin = box({0, 0, 0}, {4, 4, 4}, 1, skin_paint());
  const DiffusionSurfaces fruit = joined(skin, box({1, 1, 1}, {2, 2, 3}, 1, stone));
  for (const DiffusionSurfaces& surfaces : {fruit, turned_inside_out(fruit)}) {
    const PartRegions regions = part_regions(surfaces);
    ASSERT_EQ(regions.region.size(), 2u);
    const auto& [inner, outer] = std::pair(regions.region[0], regions.region[1]);
    EXPECT_DOUBLE_EQ(inner.volume, 2);
    EXPECT_DOUBLE_EQ(outer.volume, 64);
    EXPECT_EQ(regions.part_names[static_cast<std::size_t>(inner.part)], "stone");
    EXPECT_EQ(regions.part_names[static_cast<std::size_t>(outer.part)], "flesh");
    EXPECT_EQ(inner.count + outer.count, surfaces.triangle_count());
  }
}

TEST(PartRegions, ThatTouchAreTwo) {
  Paint left, right;
  left.name = "left", right.name = "right", right.back_part = "gel";
  const PartRegions regions =
      part_regions(joined(box({0, 0, 0}, {1, 1, 1}, 1, left), box({1, 0, 0}, {3, 1, 1}, 1, right)));
  ASSERT_EQ(regions.region.size(), 2u);
  EXPECT_DOUBLE_EQ(regions.region[0].volume, 1);
  EXPECT_DOUBLE_EQ(regions.region[1].volume, 2);
  EXPECT_EQ(regions.part_names[static_cast<std::size_t>(regions.region[1].part)], "gel");
}

/// If the inside of a box shows two parts, the one with more area counts, wherever the box lies.
TEST(PartRegions, HaveThePartThatShowsMostOfItselfWithin) {
  const RandomStream random({}, "tests/parts of a box");
  for (std::uint64_t n = 0; n < 40; ++n) {
    DiffusionSurfaces cube = box({0, 0, 0}, {1, 1, 1}, 1, skin_paint());
    cube.part_names.emplace_back("stone");
    const auto stone = static_cast<std::int32_t>(cube.part_names.size()) - 1;

    // Of the twelve triangles, all of the same area, five or seven are of the stone.
    int left = n % 2 == 0 ? 5 : 7;
    for (std::uint64_t draw = 0; left > 0; ++draw) {
      std::int32_t& part = cube.back_part[random.below(100 * n + draw, 12)];
      if (part == stone) continue;
      part = stone;
      --left;
    }
    for (const glm::dvec3& by : {glm::dvec3(0), {8, 0, 0}, {0, 8, 0}, {0, 0, -8}}) {
      const PartRegions regions = part_regions(moved(cube, by));
      ASSERT_EQ(regions.region.size(), 1u);
      EXPECT_EQ(regions.part_names[static_cast<std::size_t>(regions.region[0].part)], n % 2 == 0 ? "flesh" : "stone");
    }
  }
}

TEST(PartRegions, OpenSurfacesEncloseNothing) {
  EXPECT_TRUE(part_regions(open_sheet(1, 0, 3)).region.empty());
  EXPECT_TRUE(part_regions({}).region.empty());
}

}  // namespace
}  // namespace pomona
