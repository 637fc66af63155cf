// A fruit's surfaces as glass.
#include "generator/piece/glass_surfaces.h"

#include <set>

#include <gtest/gtest.h>

#include "tests/shapes/seeded_fruit.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

GrownFruit seeded() {
  GrownFruit fruit;
  fruit.swept = shapes::seeded_fruit();
  fruit.grains = shapes::sphere(0.004, 2, {.name = "seed"});
  return fruit;
}

TEST(GlassSurfaces, ShowEverySideOfEverySurfaceAndGrainOnce) {
  const GrownFruit fruit = seeded();
  const std::vector<Solid> glass = glass_surfaces(fruit, {}, "fruit");
  std::set<std::string> names;
  std::size_t triangles = 0;
  for (const Solid& solid : glass) {
    names.insert(solid.name);
    triangles += solid.mesh.triangle.size();
    EXPECT_GT(solid.opacity, 0);
    EXPECT_LT(solid.opacity, 1);
    EXPECT_EQ(solid.mesh.normal.size(), solid.mesh.position.size());
    EXPECT_EQ(solid.mesh.color.size(), solid.mesh.position.size());
    EXPECT_EQ(solid.mesh.surface.size(), solid.mesh.triangle.size());
    for (const glm::uvec3& t : solid.mesh.triangle) {
      for (int k = 0; k < 3; ++k) ASSERT_LT(t[k], solid.mesh.position.size());
      EXPECT_NE(solid.mesh.position[t.x], solid.mesh.position[t.y]) << solid.name;
      EXPECT_NE(solid.mesh.position[t.y], solid.mesh.position[t.z]) << solid.name;
      EXPECT_NE(solid.mesh.position[t.z], solid.mesh.position[t.x]) << solid.name;
    }
  }
  EXPECT_TRUE(names.contains("fruit.seed"));
  EXPECT_EQ(glass.size(), fruit.swept.surface_names.size() + fruit.grains.surface_names.size());
  EXPECT_EQ(triangles, 2 * (fruit.swept.triangle_count() + fruit.grains.triangle_count()));
}

TEST(GlassSurfaces, KeepTheSkinFaintAndGrainsDense) {
  const GrownFruit fruit = seeded();
  const std::vector<Solid> glass = glass_surfaces(fruit, {}, "fruit");
  EXPECT_EQ(glass.front().name, "fruit.seed");
  for (const Solid& solid : glass) EXPECT_LE(glass.back().opacity, solid.opacity) << solid.name;
  for (const Solid& solid : glass) EXPECT_GE(glass.front().opacity, solid.opacity) << solid.name;
}

TEST(GlassSurfaces, OfNothingAreNone) { EXPECT_TRUE(glass_surfaces({}, {}, "nothing").empty()); }

}  // namespace
}  // namespace pomona
