// Parts with a soft border have the same shine where they meet.
#include "render/texture/shine.h"

#include <gtest/gtest.h>

#include "render/style/pbr_roughness.h"

namespace pomona {
namespace {

/// A cut face of two squares side by side along x, each of a part and with vertices of its own: wet flesh and a dry
/// rind.
Solid two_squares(const Color& flesh, const Color& rind) {
  Solid solid;
  solid.own_look().part_names = {"flesh", "rind"};
  solid.own_look().materials.resize(2);
  solid.own_look().materials[0].wet = 2;
  solid.own_look().materials[1].wet = 0.5;
  const auto square = [&](float low, std::int32_t part, const Color& color) {
    const auto first = static_cast<std::uint32_t>(solid.mesh.position.size());
    for (const glm::vec2& at : {glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
      solid.mesh.position.emplace_back(low + at.x, at.y, 0.0f);
      solid.mesh.part.push_back(part);
      solid.mesh.color.push_back(color);
    }
    solid.mesh.triangle.insert(solid.mesh.triangle.end(),
                               {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
  };
  square(0, 0, flesh);
  square(1, 1, rind);
  solid.mesh.cut_face.assign(solid.mesh.triangle.size(), 0);
  return solid;
}

const Color red(0.6f, 0.05f, 0.05f), almost_red(0.605f, 0.05f, 0.05f), green(0.1f, 0.3f, 0.05f);

TEST(Shine, OfPartsThatLookAlikeIsTheSameFromBothSides) {
  const Solid solid = two_squares(red, almost_red);
  const Shine shine(solid);
  const double flesh = pbr_roughness(solid.look->materials[0], true),
               rind = pbr_roughness(solid.look->materials[1], true);
  ASSERT_GT(rind, flesh + 0.1);

  // The corner (1, 0): the second of the first square's triangle, and the first of the second one's.
  const PlaceShine left = shine.at(0, {0, 1, 0}), right = shine.at(2, {1, 0, 0});
  EXPECT_NEAR(left.roughness, right.roughness, 1e-12);
  EXPECT_GT(left.roughness, flesh);
  EXPECT_LT(left.roughness, rind);
  EXPECT_EQ(left.film, 0) << "the rind has none";
  EXPECT_EQ(right.film, 0);

  // Away from the border each has its material's values.
  EXPECT_NEAR(shine.at(1, {0, 0, 1}).roughness, flesh, 1e-12);
  EXPECT_EQ(shine.at(1, {0, 0, 1}).film, 1);
  EXPECT_NEAR(shine.at(2, {0, 1, 0}).roughness, rind, 1e-12);
}

TEST(Shine, EndsAtOnceWhereColoursDo) {
  const Solid solid = two_squares(red, green);
  const Shine shine(solid);
  for (const glm::dvec3& weight : {glm::dvec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}, {0.2, 0.3, 0.5}}) {
    EXPECT_NEAR(shine.at(0, weight).roughness, pbr_roughness(solid.look->materials[0], true), 1e-12);
    EXPECT_NEAR(shine.at(2, weight).roughness, pbr_roughness(solid.look->materials[1], true), 1e-12);
    EXPECT_NEAR(shine.at(0, weight).film, 1, 1e-12);
  }
}

TEST(Shine, OfSkinIsItsMaterials) {
  Solid solid = two_squares(red, red);
  solid.mesh.cut_face.assign(solid.mesh.triangle.size(), -1);
  const PlaceShine skin = Shine(solid).at(0, {0, 1, 0});
  EXPECT_EQ(skin.roughness, pbr_roughness(solid.look->materials[0], false));
  EXPECT_EQ(skin.film, 1);
}

}  // namespace
}  // namespace pomona
