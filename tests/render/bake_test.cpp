// Baked textures: every triangle has its place, colours arrive there, nothing overlaps.
#include "render/texture/bake.h"

#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "render/texture/charts.h"

namespace pomona {
namespace {

/// A half ball of radius 1, green outside, with a red cut face at y = 0 whose colour grows with x.
Solid half_ball() {
  Solid solid;
  constexpr int around = 24, up = 6;
  const auto add = [&](const glm::vec3& p, const glm::vec3& n, const Color& c) {
    solid.position.push_back(p);
    solid.normal.push_back(n);
    solid.color.push_back(c);
    solid.part.push_back(0);
    return static_cast<std::uint32_t>(solid.position.size() - 1);
  };
  const auto ring = [&](int i, int j) {
    const double a = 2 * pi * i / around, e = 0.5 * pi * j / up;
    return glm::vec3(reproducible::cos(a) * reproducible::cos(e), reproducible::sin(e),
                     -reproducible::sin(a) * reproducible::cos(e));
  };
  for (int j = 0; j < up; ++j) {
    for (int i = 0; i < around; ++i) add(ring(i, j), ring(i, j), {0, 1, 0});
  }
  const auto pole = add({0, 1, 0}, {0, 1, 0}, {0, 1, 0});
  const auto id = [&](int i, int j) { return static_cast<std::uint32_t>(j * around + i % around); };
  for (int j = 0; j < up; ++j) {
    for (int i = 0; i < around; ++i) {
      if (j + 1 < up) {
        solid.triangle.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
        solid.triangle.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
      } else {
        solid.triangle.push_back({id(i, j), id(i + 1, j), pole});
      }
    }
  }
  solid.cut_face.assign(solid.triangle.size(), -1);
  solid.surface.assign(solid.triangle.size(), 0);
  const auto center = add({0, 0, 0}, {0, -1, 0}, {0.5f, 0, 0});
  std::uint32_t first = center + 1;
  for (int i = 0; i < around; ++i) add(ring(i, 0), {0, -1, 0}, {0.5f + 0.5f * ring(i, 0).x, 0, 0});
  for (int i = 0; i < around; ++i) {
    solid.triangle.push_back(
        {center, first + static_cast<std::uint32_t>((i + 1) % around), first + static_cast<std::uint32_t>(i)});
    solid.cut_face.push_back(0);
    solid.surface.push_back(-1);
  }
  solid.part_names = {"all"};
  return solid;
}

const Style plain = style_named("plain");

TEST(Charts, HoldEveryTriangleOnceAndDoNotFold) {
  const Solid solid = half_ball();
  std::vector<int> times(solid.triangle.size(), 0);
  for (const Chart& chart : charts_of(solid)) {
    for (const std::uint32_t t : chart.triangles) {
      ++times[t];
      const glm::uvec3& v = solid.triangle[t];
      const glm::dvec2 a = chart.project(solid.position[v.x]), b = chart.project(solid.position[v.y]),
                       c = chart.project(solid.position[v.z]);
      EXPECT_GT((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x), 0) << "seen from outside, all turn the same way";
    }
  }
  for (const int n : times) EXPECT_EQ(n, 1);
}

TEST(Packing, KeepsChartsApartAndInside) {
  const std::vector<Chart> charts = charts_of(half_ball());
  const Packing packing = packed(charts, 256, 4);
  EXPECT_GT(packing.texels_per_metre, 30) << "most of the texture is used";
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const auto high = [&](std::size_t c) {
      return packing.corner[c] + glm::ivec2((charts[c].high - charts[c].low) * packing.texels_per_metre) +
             glm::ivec2(9);
    };
    EXPECT_LE(high(i).x, 256);
    EXPECT_LE(high(i).y, 256);
    for (std::size_t j = 0; j < i; ++j) {
      const bool apart = high(i).x <= packing.corner[j].x || high(j).x <= packing.corner[i].x ||
                         high(i).y <= packing.corner[j].y || high(j).y <= packing.corner[i].y;
      EXPECT_TRUE(apart) << i << " and " << j;
    }
  }
}

TEST(Bake, PutsTheColourOfEveryVertexAtItsTextureCoordinate) {
  const BakedSolid baked_solid = baked(half_ball(), plain, {.texels = 256});
  ASSERT_EQ(baked_solid.uv.size(), baked_solid.solid.position.size());
  EXPECT_EQ(baked_solid.solid.triangle.size(), half_ball().triangle.size());
  for (std::size_t v = 0; v < baked_solid.uv.size(); ++v) {
    const glm::vec2 texel = baked_solid.uv[v] * 256.0f;
    const Color found = from_srgb8(baked_solid.texture.at(static_cast<int>(texel.x), static_cast<int>(texel.y)));
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], baked_solid.solid.color[v][k], 0.012f) << v;
  }
}

TEST(Bake, GivesTheSameTextureTwice) {
  EXPECT_EQ(baked(half_ball(), plain, {.texels = 128}).texture.pixels,
            baked(half_ball(), plain, {.texels = 128}).texture.pixels);
}

TEST(Bake, DrawsInkOnTheCutFaceOnly) {
  Solid solid = half_ball();
  solid.ink_segments.push_back({{-0.5f, 0, 0}, {0.5f, 0, 0}, false});
  Style ink = style_named("ink");
  ink.noise = false;
  const auto without = baked(half_ball(), ink, {.texels = 256}).texture;
  const auto with = baked(solid, ink, {.texels = 256}).texture;
  int changed = 0;
  for (std::size_t i = 0; i < with.pixels.size(); ++i) {
    if (with.pixels[i] == without.pixels[i]) continue;
    ++changed;
    EXPECT_GT(without.pixels[i].r, without.pixels[i].g) << "only the red face has ink";
  }
  EXPECT_GT(changed, 20);
}

TEST(Bake, RefusesATextureThatCannotHoldTheCharts) { EXPECT_THROW(baked(half_ball(), plain, {.texels = 16}), Error); }

}  // namespace
}  // namespace pomona
