// Charts and the atlas: every triangle has its place, stretch is small, and mip levels keep charts apart.
#include "render/texture/uv_atlas.h"

#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/random.h"
#include "generator/knife/parse_knife.h"
#include "render/style/style_file.h"
#include "render/texture/bake.h"
#include "tests/render/half_ball.h"
#include "tests/shapes/seeded_fruit.h"
#include "tests/shapes/sliced.h"

namespace pomona {
namespace {

using named::ball;
using named::half_ball;

/// A fruit with grains, sheets and chambers after cuts by a ball and a corer.
Solid hollowed() {
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  Template painted;
  painted.parts = fruit.part_names;
  const std::vector<Knife> knives{parse_knife("ball:40mm,at=28mm,6mm,10mm"), parse_knife("core:12mm,at=-10mm,0,0")};
  return shapes::sliced(fruit, knives, painted).pieces.front();
}

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

TEST(Charts, HoldEveryTriangleOnceAndDoNotFold) {
  for (const Solid& solid : {half_ball(), ball(32, 12), hollowed()}) {
    std::vector<int> times(solid.mesh.triangle.size(), 0);
    for (const Chart& chart : charts_of(solid)) {
      ASSERT_EQ(chart.corners.size(), chart.triangles.size());
      for (std::size_t i = 0; i < chart.triangles.size(); ++i) {
        ++times[chart.triangles[i]];
        const glm::uvec3& c = chart.corners[i];
        EXPECT_LE(turn(chart.flat[c.x], chart.flat[c.y], chart.flat[c.z]), 0) << "y runs down: seen from the air";
      }
      EXPECT_TRUE(overlapping(chart.corners, chart.flat).empty());
    }
    for (const int n : times) EXPECT_EQ(n, 1);
  }
}

TEST(Charts, HardlyStretchCurvedCutFaces) {
  int curved = 0;
  for (const Chart& chart : charts_of(hollowed())) {
    if (chart.cut_face < 0) continue;
    EXPECT_LT(chart.stretch.mean, 1.2) << "half a ball as it is seen: 2";
    ++curved;
  }
  EXPECT_GT(curved, 2);
}

/// Seams between charts of a curved face get no line; its rim at the skin does.
TEST(Charts, KnowTheSeamsOfCurvedCutFaces) {
  const Solid solid = hollowed();
  const auto place = [&](std::uint32_t v) {
    const glm::vec3& p = solid.mesh.position[v];
    return std::array{p.x, p.y, p.z};
  };
  std::set<std::array<float, 3>> on_skin;
  for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) {
    for (int k = 0; k < 3 && solid.mesh.cut_face[t] < 0; ++k) on_skin.insert(place(solid.mesh.triangle[t][k]));
  }
  int seams = 0, rims = 0;
  for (const Chart& chart : charts_of(solid)) {
    if (chart.cut_face < 0) continue;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::array<std::uint32_t, 2>> border;  // ends in the solid
    for (std::size_t i = 0; i < chart.triangles.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        const auto edge = std::minmax(chart.corners[i][k], chart.corners[i][(k + 1) % 3]);
        const glm::uvec3& v = solid.mesh.triangle[chart.triangles[i]];
        if (!border.try_emplace(edge, std::array{v[k], v[(k + 1) % 3]}).second) border.erase(edge);
      }
    }
    for (const glm::uvec2& seam : chart.seams) seams += static_cast<int>(border.erase(std::minmax(seam.x, seam.y)));
    for (const auto& [edge, ends] : border) {
      EXPECT_TRUE(on_skin.contains(place(ends[0])) && on_skin.contains(place(ends[1])));
      ++rims;
    }
  }
  EXPECT_GT(seams, 50);
  EXPECT_GT(rims, 50);
}

TEST(Charts, LayCutFacesFlatAsTheyAre) {
  const Solid solid = half_ball();
  int faces = 0;
  for (const Chart& chart : charts_of(solid)) {
    if (chart.cut_face < 0) continue;
    ++faces;
    for (std::size_t i = 0; i < chart.triangles.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t a = solid.mesh.triangle[chart.triangles[i]][k],
                            b = solid.mesh.triangle[chart.triangles[i]][(k + 1) % 3];
        EXPECT_NEAR(glm::distance(chart.flat[chart.corners[i][k]], chart.flat[chart.corners[i][(k + 1) % 3]]),
                    glm::distance(glm::dvec3(solid.mesh.position[a]), glm::dvec3(solid.mesh.position[b])), 1e-6);
      }
    }
  }
  EXPECT_EQ(faces, 1);
  EXPECT_EQ(std::ssize(charts_of(named::split_plate())), 1) << "doubled vertices do not part a face";
}

TEST(Charts, OfABallAreFewAndHardlyStretched) {
  // Orthographic projection on the six sides of a cube: 6 charts, mean stretch 1.22, worst 1.73.
  const std::vector<Chart> charts = charts_of(ball(64, 24));
  EXPECT_LE(charts.size(), 6u);
  double sum = 0, worst = 1;
  for (const Chart& chart : charts) {
    sum += chart.stretch.mean / static_cast<double>(charts.size());
    worst = std::max(worst, chart.stretch.worst);
  }
  RecordProperty("mean_stretch", std::to_string(sum));
  RecordProperty("worst_stretch", std::to_string(worst));
  EXPECT_LT(sum, 1.12);
  EXPECT_LT(worst, 1.6);
}

/// A vertex that lies on an edge up to rounding makes a triangle whose shape in the plane is arbitrary.
TEST(Flatten, MeasuresNoStretchOfTrianglesTooNarrowToBeSeen) {
  const Patch3 patch{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.5, -1e-16, 0}}, {{0, 1, 2}, {0, 3, 1}}};
  std::vector<glm::dvec2> flat = {{0, 0}, {1, 0}, {1, 1}, {0.5, -1e-3}};
  const Stretch narrow = stretch_of(patch, flat);
  EXPECT_NEAR(narrow.worst, 1, 1e-9);
  EXPECT_NEAR(narrow.mean, 1, 1e-9);
  EXPECT_NEAR(narrow.area, 0.5, 1e-9);

  flat[2] = {3, 1};
  EXPECT_GT(stretch_of(patch, flat).worst, 2) << "of those that can be seen it does";
}

TEST(Flatten, FindsTrianglesThatLieOnOthers) {
  const std::vector<glm::uvec3> triangles = {{0, 1, 2}, {1, 3, 2}, {4, 5, 6}};
  std::vector<glm::dvec2> flat = {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 0}, {3, 0}, {2, 1}};
  EXPECT_TRUE(overlapping(triangles, flat).empty());
  flat[4] = {0.5, 0.2};
  EXPECT_EQ(overlapping(triangles, flat), std::vector<std::uint32_t>{2});
}

/// The owners of the four texels that a bilinear filter reads at `level`.
std::array<std::int32_t, 4> owners_at(const Atlas& atlas, const glm::dvec2& texel, int level) {
  const double width = 1 << level;
  const glm::ivec2 low(glm::floor(texel / width - 0.5));
  std::array<std::int32_t, 4> owners{};
  for (int i = 0; i < 4; ++i) {
    const glm::ivec2 block = (low + glm::ivec2(i % 2, i / 2)) * (1 << level) / atlas.block();
    owners[static_cast<std::size_t>(i)] = atlas.owner[static_cast<std::size_t>(block.y) * atlas.blocks().x + block.x];
  }
  return owners;
}

void expect_apart(const std::vector<Chart>& charts, const Atlas& atlas) {
  const RandomStream random({1, 2}, "atlas");
  std::uint64_t draw = 0;
  for (std::size_t c = 0; c < charts.size(); ++c) {
    for (const glm::uvec3& t : charts[c].corners) {
      double u = random.uniform(draw), v = random.uniform(draw + 1);
      draw += 2;
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const glm::dvec2 p =
          atlas.texel(charts, c, t.x) * (1 - u - v) + atlas.texel(charts, c, t.y) * u + atlas.texel(charts, c, t.z) * v;
      for (int level = 0; level <= atlas.mip_levels; ++level) {
        if (atlas.speck[c] != 0 && level > 0) continue;  // reads its own block with full weight
        for (const std::int32_t owner : owners_at(atlas, p, level)) ASSERT_EQ(owner, static_cast<std::int32_t>(c));
      }
    }
  }
}

TEST(Atlas, GivesAChartEveryBlockThatALookUpReads) {
  const std::vector<Chart> charts = charts_of(ball(48, 16));
  for (const int side : {64, 128, 256, 1024}) {
    const auto [turned, atlas] = packed_to_side(charts, side, 3);
    EXPECT_EQ(atlas.size, glm::ivec2(side));
    expect_apart(turned, atlas);
  }
  const auto [turned, fixed] = packed_at_texel(charts, 0.013, 4);
  EXPECT_EQ(fixed.mip_levels, 4);
  expect_apart(turned, fixed);
}

TEST(Atlas, GivesUpMipLevelsRatherThanTexels) {
  const std::vector<Chart> charts = charts_of(ball(48, 16));
  EXPECT_EQ(packed_to_side(charts, 1024, 3).atlas.mip_levels, 3);
  EXPECT_LT(packed_to_side(charts, 32, 3).atlas.mip_levels, 3);
}

/// Six equal circles cover at most two thirds of a square; a ball's six charts are nearly circles, plus their borders.
TEST(Atlas, IsWellFilled) {
  const auto filled = [](const Solid& solid) {
    const std::vector<Chart> charts = charts_of(solid);
    return filled_share(charts, packed_to_side(charts, 1024, 3).atlas);
  };
  EXPECT_GT(filled(ball(48, 16)), 0.57);
  EXPECT_GT(filled(half_ball()), 0.63);
}

/// Flat cut faces are not turned; curved charts are turned and keep their shape.
TEST(Atlas, TurnsCurvedChartsAlone) {
  const std::vector<Chart> charts = charts_of(half_ball());
  const std::vector<Chart> placed = packed_to_side(charts, 512, 3).charts;
  ASSERT_EQ(placed.size(), charts.size());
  int turned = 0;
  for (std::size_t c = 0; c < charts.size(); ++c) {
    glm::dvec2 low = placed[c].flat[0], high = low;
    for (std::size_t i = 0; i < charts[c].flat.size(); ++i) {
      const glm::dvec2 &p = placed[c].flat[i], &q = charts[c].flat[i];
      low = glm::min(low, p), high = glm::max(high, p);
      EXPECT_NEAR(glm::distance(p, placed[c].flat[0]), glm::distance(q, charts[c].flat[0]), 1e-12);
      EXPECT_TRUE(p == q || !charts[c].frame);
    }
    EXPECT_NEAR(glm::length(low), 0, 1e-12);
    EXPECT_NEAR(glm::distance(high, placed[c].size), 0, 1e-12);
    for (const glm::uvec3& t : placed[c].corners)
      EXPECT_LE(turn(placed[c].flat[t.x], placed[c].flat[t.y], placed[c].flat[t.z]), 1e-18) << "not mirrored";
    turned += placed[c].flat == charts[c].flat ? 0 : 1;
  }
  EXPECT_GT(turned, 0);
}

/// The next mip level: means of two by two texels in linear light, as graphics cards compute them for sRGB textures.
struct LinearImage {
  int width = 0, height = 0;
  std::vector<glm::dvec3> pixels;
  const glm::dvec3& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

LinearImage halved(const LinearImage& fine) {
  LinearImage half{fine.width / 2, fine.height / 2, {}};
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      half.pixels.push_back(0.25 * (fine.at(2 * x, 2 * y) + fine.at(2 * x + 1, 2 * y) + fine.at(2 * x, 2 * y + 1) +
                                    fine.at(2 * x + 1, 2 * y + 1)));
    }
  }
  return half;
}

glm::dvec3 bilinear(const LinearImage& image, const glm::dvec2& uv) {
  const glm::dvec2 at = uv * glm::dvec2(image.width, image.height) - 0.5;
  const glm::ivec2 low(glm::floor(at));
  const glm::dvec2 f = at - glm::dvec2(low);
  const auto texel = [&](int dx, int dy) {
    return image.at(std::clamp(low.x + dx, 0, image.width - 1), std::clamp(low.y + dy, 0, image.height - 1));
  };
  return glm::mix(glm::mix(texel(0, 0), texel(1, 0), f.x), glm::mix(texel(0, 1), texel(1, 1), f.x), f.y);
}

TEST(Atlas, NoForeignColourComesInWithinThePromisedMipLevels) {
  // Skin pure green, face pure red: any other channel comes from another chart, or from none.
  Solid solid = half_ball();
  for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) {
    for (int k = 0; k < 3; ++k)
      solid.mesh.color[solid.mesh.triangle[t][k]] = solid.mesh.cut_face[t] < 0 ? Color(0, 1, 0) : Color(1, 0, 0);
  }
  const BakedSolid baked_solid = baked(solid, style_named("plain"), {.texels = 256});
  ASSERT_GE(baked_solid.mip_levels, 2);
  LinearImage level{256, 256, {}};
  for (const glm::u8vec3& pixel : baked_solid.texture.pixels) level.pixels.emplace_back(from_srgb8(pixel));
  for (int l = 0; l <= baked_solid.mip_levels; ++l) {
    for (std::size_t t = 0; t < baked_solid.solid.mesh.triangle.size(); ++t) {
      const glm::uvec3& v = baked_solid.solid.mesh.triangle[t];
      for (const glm::dvec3 w : {glm::dvec3(1, 0, 0), {0, 0.5, 0.5}, {1 / 3., 1 / 3., 1 / 3.}}) {
        const glm::dvec3 found =
            bilinear(level, glm::dvec2(baked_solid.uv[v.x]) * w.x + glm::dvec2(baked_solid.uv[v.y]) * w.y +
                                glm::dvec2(baked_solid.uv[v.z]) * w.z);
        const bool skin = baked_solid.solid.mesh.cut_face[t] < 0;
        ASSERT_NEAR(found.r, skin ? 0 : 1, 1e-4) << "level " << l;
        ASSERT_NEAR(found.g, skin ? 1 : 0, 1e-4) << "level " << l;
      }
    }
    level = halved(level);
  }
}

}  // namespace
}  // namespace pomona
