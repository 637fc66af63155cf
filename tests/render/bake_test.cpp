// Baked textures: each place has its own colour and no other place's.
#include "render/texture/bake.h"

#include <gtest/gtest.h>
#include <cmath>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/piece/section_colors.h"
#include "render/style/style_file.h"
#include "tests/render/half_ball.h"

namespace pomona {
namespace {

using named::half_ball;
const Style plain = style_named("plain");

/// A field of colours that a function gives.
template <typename Function>
class GivenDiffuser final : public Diffuser {
 public:
  explicit GivenDiffuser(Function function) : function_(function) {}
  const char* name() const override { return "given"; }
  std::unique_ptr<ColorField> field(const DiffusionSurfaces&) const override {
    return std::make_unique<GivenField>(function_);
  }

 private:
  struct GivenField final : ColorField {
    explicit GivenField(Function function) : function_(function) {}
    DiffusedColors at(std::span<const glm::vec3> points) const override {
      DiffusedColors colors;
      for (const glm::vec3& p : points) colors.color.push_back(function_(p));
      colors.part.assign(points.size(), 0);
      return colors;
    }
    Function function_;
  };
  Function function_;
};

template <typename Function>
Solid colored_by(Solid solid, const GivenDiffuser<Function>& diffuser) {
  solid.section_colors = std::make_shared<const SectionColors>(DiffusionSurfaces{}, Template{}, diffuser);
  return solid;
}

/// The place of a texel's middle on one cut face of a baked solid, only from the texture coordinates; nothing beside
/// the face.
std::optional<glm::dvec3> place_of_texel(const BakedSolid& baked, int x, int y) {
  const glm::dvec2 size(baked.texture.width, baked.texture.height);
  for (std::size_t t = 0; t < baked.solid.mesh.triangle.size(); ++t) {
    if (baked.solid.mesh.cut_face[t] < 0) continue;
    const glm::uvec3& v = baked.solid.mesh.triangle[t];
    const glm::dvec2 a = glm::dvec2(baked.uv[v.x]) * size, b = glm::dvec2(baked.uv[v.y]) * size - a,
                     c = glm::dvec2(baked.uv[v.z]) * size - a, p = glm::dvec2(x + 0.5, y + 0.5) - a;
    const double area = b.x * c.y - b.y * c.x;
    const double s = (p.x * c.y - p.y * c.x) / area, r = (b.x * p.y - b.y * p.x) / area;
    if (s < 0 || r < 0 || s + r > 1) continue;
    return glm::dvec3(baked.solid.mesh.position[v.x]) * (1 - s - r) + glm::dvec3(baked.solid.mesh.position[v.y]) * s +
           glm::dvec3(baked.solid.mesh.position[v.z]) * r;
  }
  return std::nullopt;
}

int difference(const glm::u8vec3& a, const glm::u8vec3& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

TEST(Bake, PutsTheColourOfEveryVertexAtItsTextureCoordinate) {
  const BakedSolid baked_solid = baked(half_ball(), plain, {.texels = 256});
  ASSERT_EQ(baked_solid.uv.size(), baked_solid.solid.mesh.position.size());
  EXPECT_EQ(baked_solid.solid.mesh.triangle.size(), half_ball().mesh.triangle.size());
  for (std::size_t v = 0; v < baked_solid.uv.size(); ++v) {
    const glm::vec2 texel = baked_solid.uv[v] * 256.0f;
    const Color found = from_srgb8(baked_solid.texture.at(static_cast<int>(texel.x), static_cast<int>(texel.y)));
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], baked_solid.solid.mesh.color[v][k], 0.012f) << v;
  }
}

/// The half ball, the vertices of its cut face coloured by the same function as the face.
template <typename Function>
Solid half_ball_coloured_by(const GivenDiffuser<Function>& diffuser, const Function& function) {
  Solid solid = half_ball();
  for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) {
    for (int k = 0; solid.mesh.cut_face[t] >= 0 && k < 3; ++k) {
      const std::uint32_t v = solid.mesh.triangle[t][k];
      solid.mesh.color[v] = function(solid.mesh.position[v]);
    }
  }
  return colored_by(solid, diffuser);
}

TEST(Bake, FollowsAFieldBetweenThePointsItAsksFor) {
  // A bump in the middle and waves all over.
  const auto waves = [](const glm::vec3& p) {
    const float bump = 1 / (1 + 6 * (p.x * p.x + p.z * p.z));
    return Color(0.2f + 0.6f * bump, 0.3f + 0.2f * p.x * p.z, 0.5f + 0.25f * p.x * (1 - p.z * p.z));
  };
  const GivenDiffuser diffuser(waves);
  const BakedSolid result = baked(half_ball_coloured_by(diffuser, waves), plain, {.texels = 512});
  std::size_t checked = 0, far_off = 0;
  for (int y = 0; y < 512; y += 3) {
    for (int x = 0; x < 512; x += 3) {
      const auto p = place_of_texel(result, x, y);
      // Texels near the round rim may lie outside its polygon, where the colours are those of vertices.
      if (!p || glm::length(*p) > 0.97) continue;
      ++checked;
      far_off += difference(result.texture.at(x, y), to_srgb8(waves(glm::vec3(*p)))) > 2 ? 1 : 0;
    }
  }
  EXPECT_GT(checked, 2000u);
  EXPECT_LE(far_off, checked / 200);
  EXPECT_LT(result.diffused, checked) << "with nine times as many texels";
}

TEST(Bake, DiffusesEveryTexelAtItsOwnPlaceIfAsked) {
  // Linear in space, like positive mean values and harmonic functions between linear colours. The vertices have other
  // colours.
  const GivenDiffuser linear([](const glm::vec3& p) { return Color(0.5f + 0.3f * p.x, 0.5f - 0.3f * p.z, 0.25f); });
  const BakedSolid result = baked(colored_by(half_ball(), linear), plain, {.texels = 128, .every_texel = true});
  int checked = 0;
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) {
      const auto p = place_of_texel(result, x, y);
      if (!p) continue;
      ++checked;
      const glm::u8vec3 expected = to_srgb8(Color(0.5 + 0.3 * p->x, 0.5 - 0.3 * p->z, 0.25));
      EXPECT_LE(difference(result.texture.at(x, y), expected), 1) << x << " " << y;
    }
  }
  EXPECT_GT(checked, 1500);
  EXPECT_EQ(result.diffused, static_cast<std::size_t>(checked));
}

TEST(Bake, KeepsConstantsToTheBit) {
  const GivenDiffuser constant([](const glm::vec3&) { return Color(0.4f, 0.2f, 0.1f); });
  Solid solid = half_ball();
  for (Color& color : solid.mesh.color) color = {0.4f, 0.2f, 0.1f};
  const BakedSolid result = baked(colored_by(solid, constant), plain, {.texels = 128});
  for (const glm::u8vec3& pixel : result.texture.pixels) EXPECT_EQ(pixel, to_srgb8(Color(0.4f, 0.2f, 0.1f)));
}

TEST(Bake, KeepsColoursApartWhereASurfaceCrosses) {
  // Blue left of x = 0, red right of it, and doubled vertices along the line.
  const GivenDiffuser step([](const glm::vec3& p) { return p.x < 0 ? Color(0, 0, 1) : Color(1, 0, 0); });
  const BakedSolid result = baked(colored_by(named::split_plate(), step), plain, {.texels = 128});
  int mixed = 0, left = 0, right = 0;
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) {
      const auto p = place_of_texel(result, x, y);
      if (!p) continue;
      const glm::u8vec3 found = result.texture.at(x, y);
      if (std::abs(p->x) < 0.5 * result.texel + 1e-6) {
        // A texel on the line shows both sides in linear light, or one of them.
        mixed += found.r > 0 && found.b > 0 ? 1 : 0;
        continue;
      }
      (p->x < 0 ? left : right) += 1;
      EXPECT_EQ(found, p->x < 0 ? glm::u8vec3(0, 0, 255) : glm::u8vec3(255, 0, 0)) << x << " " << y;
    }
  }
  EXPECT_GT(left, 1000);
  EXPECT_GT(right, 1000);
  EXPECT_LT(mixed, 128);
}

TEST(Bake, HonoursTheSizeOfATexel) {
  for (const double wanted : {0.05, 0.02, 0.0101}) {
    const BakedSolid result = baked(half_ball(), plain, {.texel = wanted});
    EXPECT_DOUBLE_EQ(result.texel, wanted);
    const glm::dvec2 size(result.texture.width, result.texture.height);
    for (std::size_t t = 0; t < result.solid.mesh.triangle.size(); ++t) {
      if (result.solid.mesh.cut_face[t] < 0) continue;
      const glm::uvec3& v = result.solid.mesh.triangle[t];
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t a = v[k], b = v[(k + 1) % 3];
        const double in_space =
            glm::distance(glm::dvec3(result.solid.mesh.position[a]), glm::dvec3(result.solid.mesh.position[b]));
        const double texels = glm::distance(glm::dvec2(result.uv[a]) * size, glm::dvec2(result.uv[b]) * size);
        EXPECT_NEAR(texels * wanted, in_space, 0.001 * in_space);
      }
    }
  }
}

TEST(Bake, TakesTheSmallestTextureThatHoldsTheTexels) {
  const BakedSolid coarse = baked(half_ball(), plain, {.texel = 0.05}),
                   fine = baked(half_ball(), plain, {.texel = 0.01});
  EXPECT_LE(coarse.texture.width, 256);
  EXPECT_GT(fine.texture.width * fine.texture.height, 10 * coarse.texture.width * coarse.texture.height);
  for (const BakedSolid& solid : {coarse, fine}) {
    EXPECT_EQ(solid.texture.width & (solid.texture.width - 1), 0) << "powers of two";
    EXPECT_EQ(solid.texture.height & (solid.texture.height - 1), 0);
  }
}

TEST(Bake, GivesTheSameTextureForAnyNumberOfThreads) {
  Solid solid = half_ball();
  solid.own_look().noise.base_frequency = 3;
  solid.own_look().noise.keys.push_back({.color = {0.7f, 0, 0}, .weights = {0.1, 0.1}, .axis = {1, 0, 0}});
  const BakedSolid one = baked(solid, style_named("ink"), {.texels = 128, .threads = {1}});
  const BakedSolid four = baked(solid, style_named("ink"), {.texels = 128, .threads = {4}});
  EXPECT_EQ(one.texture.pixels, four.texture.pixels);
  EXPECT_EQ(one.uv, four.uv);
}

TEST(Bake, DrawsInkOnTheCutFaceOnly) {
  const GivenDiffuser step([](const glm::vec3& p) { return p.x < 0 ? Color(0, 0, 1) : Color(1, 0, 0); });
  Style ink = style_named("ink");
  ink.noise = false;
  const Solid plate = colored_by(named::split_plate(), step);
  const Image without = baked(plate, plain, {.texels = 256}).texture, with = baked(plate, ink, {.texels = 256}).texture;
  int changed = 0;
  for (std::size_t i = 0; i < with.pixels.size(); ++i) changed += with.pixels[i] != without.pixels[i] ? 1 : 0;
  EXPECT_GT(changed, 300) << "its rim and the line";
  const Solid skin = named::without_cut_faces(half_ball());
  EXPECT_EQ(baked(skin, plain, {.texels = 128}).texture.pixels, baked(skin, ink, {.texels = 128}).texture.pixels);
}

TEST(Bake, ChecksSizesBeforeAnythingIsMadeOfThem) {
  EXPECT_THROW(baked(half_ball(), plain, {.texel = 1e-9}), Error);
  EXPECT_THROW(baked(half_ball(), plain, {.texel = 1e-300}), Error);
  EXPECT_THROW(baked(half_ball(), plain, {.texel = 2.0 / 8192}), Error) << "the face alone would fill the texture";
  EXPECT_THROW(baked(half_ball(), plain, {.texels = 1}), Error) << "fewer texels than charts";
  EXPECT_EQ(baked(half_ball(), plain, {.texel = 1e9}).texture.width, 64) << "each chart is a speck";
}

TEST(Bake, GivesASpeckTheMeanOfItsColours) {
  Solid solid = half_ball();
  for (Color& color : solid.mesh.color) color = {0.4f, 0.2f, 0.1f};
  for (const glm::u8vec3& pixel : baked(solid, plain, {.texel = 100}).texture.pixels)
    EXPECT_LE(difference(pixel, to_srgb8(Color(0.4f, 0.2f, 0.1f))), 0);
}

TEST(Bake, ASolidWithoutTrianglesHasNoTexture) {
  const BakedSolid nothing = baked(Solid{}, plain);
  EXPECT_EQ(nothing.texture.width, 0);
  EXPECT_TRUE(nothing.uv.empty());
}

TEST(Bake, ToleratesTrianglesWithoutArea) {
  Solid solid = half_ball();
  const std::uint32_t a = solid.mesh.triangle.front().x, b = solid.mesh.triangle.front().y;
  for (const glm::uvec3 flat : {glm::uvec3(a, b, b), glm::uvec3(a, a, a), glm::uvec3(a, b, a)}) {
    solid.mesh.triangle.push_back(flat);
    solid.mesh.cut_face.push_back(-1);
    solid.mesh.surface.push_back(0);
  }
  EXPECT_EQ(baked(solid, plain, {.texels = 128}).solid.mesh.triangle.size(), solid.mesh.triangle.size());
}

}  // namespace
}  // namespace pomona
