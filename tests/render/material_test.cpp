// Gloss, bloom, fuzz and translucency in pictures.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gmock/gmock.h>

#include "generator/base/units.h"
#include "render/gl/scene_picture.h"
#include "render/style/hairs.h"
#include "render/style/style_file.h"
#include "tests/render/painted_shapes.h"

namespace pomona {
namespace {

constexpr PictureOptions small{.width = 96, .height = 72};

Scene ball_of(const MaterialSketch& material) {
  Scene scene = testing::ball_scene();
  scene.solids[0].own_look().materials = {material};
  return scene;
}

/// Only direct light, from this azimuth, level with the eye.
Style lit_from(double azimuth) {
  Style style = style_named("plain");
  style.gloss = 0;
  style.light.azimuth = azimuth;
  style.light.elevation = 0.2;
  return style;
}

/// The mean of all pixels, linear, all channels.
double radiance(const Image& image) {
  double sum = 0;
  for (const glm::u8vec3& pixel : image.pixels) {
    for (int k = 0; k < 3; ++k) sum += linear_from_srgb(pixel[k] / 255.0);
  }
  return sum / static_cast<double>(image.pixels.size());
}

double radiance_all_around(GlContext& context, const MaterialSketch& material) {
  double sum = 0;
  for (int i = 0; i < 4; ++i) sum += radiance(draw_scene(context, ball_of(material), lit_from(i * pi / 2), small));
  return sum;
}

TEST(Materials, NothingSaidIsTheDefault) {
  MaterialSketch without;
  without.fuzz = {.length = 0, .density = 9};
  without.translucency = {.depth = 0, .color = Color(1, 0, 0)};
  without.bloom = {.cover = 0, .color = Color(1)};
  const Style style = style_named("ink");
  EXPECT_EQ(draw_scene(ball_of(without), style, small).pixels, draw_scene(testing::ball_scene(), style, small).pixels);
}

TEST(Materials, TranslucencyAddsNoLight) {
  GlContext context;
  const double opaque = radiance_all_around(context, {});
  for (const double depth : {0.002, 0.02}) {
    MaterialSketch clear, tinted;
    clear.translucency = {.depth = depth};
    tinted.translucency = {.depth = depth, .color = Color(1, 0.3f, 0.1f)};
    const double untinted = radiance_all_around(context, clear);
    const double eight_bits = 1e-4 * opaque;  // the effect of rounding on the mean of the pixels
    EXPECT_LE(untinted, opaque + eight_bits) << depth;
    EXPECT_LE(radiance_all_around(context, tinted), untinted + eight_bits) << depth;
    EXPECT_GT(std::fabs(untinted - opaque), 1e-5) << depth;
  }
}

/// An upright slab, 5 cm wide and high, its broad sides towards +Z and -Z.
Scene slab(float thickness, const MaterialSketch& material) {
  Solid solid;
  solid.name = "slab";
  solid.own_look().part_names = {"gel"};
  solid.own_look().materials = {material};
  const glm::vec3 half(0.025f, 0.025f, 0.5f * thickness);
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      const auto first = static_cast<std::uint32_t>(solid.mesh.position.size());
      for (int corner = 0; corner < 4; ++corner) {
        glm::vec3 p(0);
        p[axis] = side;
        p[(axis + 1) % 3] = (corner == 1 || corner == 2) ? 1.0f : -1.0f;
        p[(axis + 2) % 3] = corner >= 2 ? 1.0f : -1.0f;
        glm::vec3 n(0);
        n[axis] = side;
        solid.mesh.position.push_back(p * half + glm::vec3(0, half.y, 0));
        solid.mesh.normal.push_back(n);
        solid.mesh.color.emplace_back(0.7f, 0.4f, 0.2f);
        solid.mesh.part.push_back(0);
      }
      const glm::uvec3 a(first, first + 1, first + 2), b(first, first + 2, first + 3);
      solid.mesh.triangle.push_back(side > 0 ? a : glm::uvec3(a.x, a.z, a.y));
      solid.mesh.triangle.push_back(side > 0 ? b : glm::uvec3(b.x, b.z, b.y));
      solid.mesh.cut_face.insert(solid.mesh.cut_face.end(), 2, -1);
      solid.mesh.surface.insert(solid.mesh.surface.end(), 2, 0);
    }
  }
  Scene scene;
  scene.solids = {solid};
  scene.instances = {{0, {}, "slab"}};
  scene.view = {.eye = {0, 0.025, 0.25}, .target = {0, 0.025, 0}, .vertical_field = 0.25};
  return scene;
}

TEST(Materials, ThinSlicesGlowAgainstTheLight) {
  MaterialSketch gel;
  gel.translucency = {.depth = 0.004, .color = Color(1, 0.6f, 0.2f)};
  const glm::u8vec3 opaque = draw_scene(slab(0.001f, {}), lit_from(pi), small).at(48, 36);
  glm::u8vec3 before(255);
  for (const float thickness : {0.001f, 0.003f, 0.008f, 0.02f}) {
    const glm::u8vec3 through = draw_scene(slab(thickness, gel), lit_from(pi), small).at(48, 36);
    EXPECT_LT(through.r, before.r) << thickness;
    EXPECT_GE(through.r, opaque.r) << thickness;
    // Red goes farthest: transmitted light is warmer than the slab.
    if (thickness < 0.01f) {
      EXPECT_GT(static_cast<double>(through.r) / opaque.r, static_cast<double>(through.b) / opaque.b) << thickness;
    }
    before = through;
  }
}

/// A cap lies on its skin, and what leaves through it comes back: it is no grey bowl.
TEST(Materials, ThinCutFacesAreAsBrightAsThickOnes) {
  MaterialSketch white;
  white.translucency = {.depth = 0.002};
  const auto face = [&](float thickness) {
    Scene scene = slab(thickness, white);
    std::vector<std::int32_t>& cut_face = scene.solids[0].mesh.cut_face;
    std::fill(cut_face.begin(), cut_face.end(), 0);
    return draw_scene(scene, lit_from(0), small).at(48, 36);
  };
  const glm::u8vec3 thick = face(0.02f);
  for (const float thickness : {0.002f, 0.004f}) {
    const glm::u8vec3 thin = face(thickness);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(thin[k], thick[k], 0.05 * thick[k]) << thickness;
  }
}

/// On raised spots the side towards the light is brighter, on sunk spots darker.
TEST(Materials, SpotsStandOutOrAreSunk) {
  Style style = style_named("ink");
  style.ink = false;
  style.gloss = 0;
  style.light.azimuth = -pi / 2;  // from the left
  style.light.elevation = 0.6;
  Spot spot;
  spot.center = {0, 0.025, 0.0025};
  spot.normal = {0, 0, 1};
  spot.tangent = {0, 1, 0};
  spot.radius = 0.012;
  spot.softness = 1;
  const auto brighter_to_the_left = [&](double relief) {
    spot.relief = relief;
    Scene scene = slab(0.005f, {});
    if (relief != 0) scene.solids[0].raised = {spot};
    const Image picture = draw_scene(scene, style, small);
    return int{picture.at(44, 36).g} - int{picture.at(52, 36).g};
  };
  EXPECT_LT(std::abs(brighter_to_the_left(0)), 8);
  EXPECT_GT(brighter_to_the_left(0.004), 12);
  EXPECT_LT(brighter_to_the_left(-0.004), -12);
}

TEST(Materials, GlossBrightensAndBloomVeils) {
  Style style = style_named("ink");
  style.ink = false;
  MaterialSketch dull, glossy, veiled;
  dull.gloss = 0;
  glossy.gloss = 2;
  glossy.roughness = 0.12;
  veiled.bloom = {.cover = 0.8, .color = Color(0.7f, 0.75f, 0.85f), .rubbed = 0};
  const Image plain = draw_scene(ball_of(dull), style, small), shiny = draw_scene(ball_of(glossy), style, small);
  int brightened = 0;
  for (std::size_t i = 0; i < plain.pixels.size(); ++i) {
    brightened = std::max(brightened, int{shiny.pixels[i].g} - int{plain.pixels[i].g});
  }
  EXPECT_GT(brightened, 60);
  EXPECT_GT(draw_scene(ball_of(veiled), style, small).at(48, 36).b, plain.at(48, 36).b + 20);
}

TEST(Materials, FuzzStandsOutBeyondTheSkin) {
  MaterialSketch hairy;
  hairy.fuzz = {.length = 0.003, .density = 0.6, .color = Color(0.1f, 0.3f, 0.05f), .lie = 0};
  const Style style = style_named("plain");
  const Image bald = draw_scene(testing::ball_scene(), style, small), image = draw_scene(ball_of(hairy), style, small);
  int beyond = 0;
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) beyond += bald.at(x, y) == bald.at(0, 0) && image.at(x, y) != bald.at(x, y);
  }
  EXPECT_GT(beyond, 60);
}

TEST(Hairs, StandOnTheSkinAsDenselyAsAsked) {
  Solid ball = testing::half_ball();
  ball.own_look().materials = {MaterialSketch{}, MaterialSketch{}};
  EXPECT_TRUE(hairs_of(ball).empty());
  ball.own_look().materials[0].fuzz = {.length = 0.002, .density = 0.5, .color = Color(0.5f), .lie = 0.5};
  const std::vector<Hair> hairs = hairs_of(ball);
  EXPECT_NEAR(static_cast<double>(hairs.size()), 0.5 * 2 * pi * 40 * 40, 20);
  for (const Hair& hair : hairs) {
    EXPECT_LE(hair.root.z, 1e-6f);  // no hairs on the cut face
    EXPECT_NEAR(glm::length(hair.root - glm::vec3(0, 0.04f, 0)), 0.04f, 2e-4f);
    EXPECT_LE(glm::length(hair.tip - hair.root), 0.0021f);
    EXPECT_GT(glm::dot(hair.tip - hair.root, hair.normal), 0);
  }
  EXPECT_EQ(hairs_of(ball, 100).size(), 100u);
  EXPECT_EQ(hairs_of(ball)[7].tip, hairs[7].tip);
}

}  // namespace
}  // namespace pomona
