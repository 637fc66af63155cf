#include "render/thumbnail/thumbnail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "render/image/png.h"
#include "render/thumbnail/covered_samples.h"
#include "render/thumbnail/sample_grid.h"

namespace pomona {
namespace {

/// A closed red cube of 2 cm on the ground; its top is a cut face, and white.
Solid cube() {
  Solid solid;
  solid.name = "cube";
  solid.own_look().part_names = {"skin", "flesh"};
  const auto quad = [&](glm::vec3 corner, glm::vec3 u, glm::vec3 v, bool cut) {
    const auto first = static_cast<std::uint32_t>(solid.mesh.position.size());
    const glm::vec3 normal = glm::normalize(glm::cross(u, v));
    for (const glm::vec3& p : {corner, corner + u, corner + u + v, corner + v}) {
      solid.mesh.position.push_back(0.02f * p);
      solid.mesh.normal.push_back(normal);
      solid.mesh.color.push_back(cut ? Color(0.9f) : Color(0.6f, 0.02f, 0.02f));
      solid.mesh.part.push_back(cut ? 1 : 0);
    }
    for (const glm::uvec3& t : {glm::uvec3(0, 1, 2), glm::uvec3(0, 2, 3)}) {
      solid.mesh.triangle.push_back(t + first);
      solid.mesh.cut_face.push_back(cut ? 0 : -1);
      solid.mesh.surface.push_back(cut ? -1 : 0);
    }
  };
  const glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), o(0);
  quad(o, y, x, false);
  quad(z, x, y, false);
  quad(o, z, y, false);
  quad(x, y, z, false);
  quad(o, x, z, false);
  quad(y, z, x, true);
  return solid;
}

Scene scene_of_a_cube() {
  Scene scene = gathered({cube()});
  scene.ground = true;
  return scene;
}

TransparentImage drawn(const Style& style, const ThumbnailOptions& options, int threads = 1) {
  const Scene scene = scene_of_a_cube();
  return draw_thumbnail(scene, styled_meshes(scene, {.style = style, .threads = {threads}}), style, options);
}

std::size_t pixel(const TransparentImage& image, int x, int y) {
  return static_cast<std::size_t>(y) * image.image.width + x;
}

TEST(Thumbnail, IsTheSameByteForByteWhateverTheThreads) {
  EXPECT_EQ(write_png(drawn({}, {.size = 64}, 1)), write_png(drawn({}, {.size = 64}, 4)));
}

TEST(Thumbnail, ShowsThePieceOpaqueAndTheGroundThroughTheShadow) {
  const TransparentImage image = drawn({}, {.size = 64});
  ASSERT_EQ(image.image.pixels.size(), 64u * 64u);
  EXPECT_EQ(image.opacity[pixel(image, 32, 32)], 255);
  for (const auto& [x, y] : {std::pair(0, 0), {63, 0}, {0, 63}, {63, 63}})
    EXPECT_EQ(image.opacity[pixel(image, x, y)], 0);

  // There is a dark, half transparent shadow.
  const auto is_shadow = [&](std::size_t i) {
    return image.opacity[i] > 20 && image.opacity[i] < 200 && image.image.pixels[i].r < 120;
  };
  int shadow = 0;
  for (std::size_t i = 0; i < image.opacity.size(); ++i) shadow += is_shadow(i);
  EXPECT_GT(shadow, 50);
}

TEST(Thumbnail, OnPaperNothingIsSeeThrough) {
  const Style style;
  const TransparentImage image = drawn(style, {.size = 64, .on_paper = true});
  EXPECT_THAT(image.opacity, testing::Each(255));
  EXPECT_EQ(image.image.pixels[0], to_srgb8(style.paper));
}

TEST(Thumbnail, KeepsTheColoursOfCutFacesAndOfSkin) {
  // Without ink, the upper face is grey and lighter than the red skin.
  Style style;
  style.ink = false;
  const TransparentImage image = drawn(style, {.size = 64});
  int red = 0, white = 0;
  for (std::size_t i = 0; i < image.opacity.size(); ++i) {
    if (image.opacity[i] < 255) continue;
    const glm::ivec3 c(image.image.pixels[i]);
    red += c.r > 80 && c.g < c.r / 2 && c.b < c.r / 2;
    white += c.r > 200 && c.g > 190 && c.b > 170;
  }
  EXPECT_GT(red, 300);
  EXPECT_GT(white, 150);
}

TEST(Thumbnail, DrawsInkAsTheStyleSays) {
  Style without;
  without.ink = false;
  const auto dark = [](const TransparentImage& image) {
    int count = 0;
    for (std::size_t i = 0; i < image.opacity.size(); ++i)
      count += image.opacity[i] > 200 && glm::ivec3(image.image.pixels[i]).r < 60;
    return count;
  };
  EXPECT_GT(dark(drawn({}, {.size = 256})), dark(drawn(without, {.size = 256})) + 400);
}

TEST(Thumbnail, RefusesSizesThatAreNone) {
  EXPECT_THROW(drawn({}, {.size = 15}), Error);
  EXPECT_THROW(drawn({}, {.size = 1025}), Error);
}

TEST(CoveredSamples, OfTwoTrianglesThatShareAnEdgeLeaveNoGap) {
  // A square across whole samples, cut in two along any diagonal: its samples, each at least once.
  constexpr int side = 32;
  for (const double shift : {0.0, 0.03125, 0.37, 0.5}) {
    const ProjectedPoint a{2 + shift, 3, 1}, b{29, 2 + shift, 1}, c{28 + shift, 30, 1}, d{3, 29 - shift, 1};
    std::map<std::pair<int, int>, int> visits;
    const auto visit = [&](int x, int y, const glm::dvec3& weight) {
      EXPECT_NEAR(weight.x + weight.y + weight.z, 1, 1e-12);
      ++visits[{x, y}];
    };
    for_covered_samples({a, b, c}, side, visit);
    for_covered_samples({a, d, c}, side, visit);  // turns the other way
    for (int y = 5; y < 27; ++y)
      for (int x = 5; x < 27; ++x) EXPECT_GE((visits[{x, y}]), 1) << x << " " << y;
  }
}

TEST(CoveredSamples, KeepToThePicture) {
  constexpr int side = 8;
  int visits = 0;
  for_covered_samples({ProjectedPoint{-1e9, -1e9, 1}, {1e9, -1e9, 1}, {0, 1e9, 1}}, side,
                      [&](int x, int y, const glm::dvec3&) {
                        EXPECT_TRUE(x >= 0 && x < side && y >= 0 && y < side);
                        ++visits;
                      });
  EXPECT_EQ(visits, side * side);
  for_covered_samples({ProjectedPoint{20, 20, 1}, {30, 20, 1}, {20, 30, 1}}, side,
                      [](int, int, const glm::dvec3&) { ADD_FAILURE(); });
}

TEST(SampleGrid, ShowsWhatIsNearestInAnyOrder) {
  const auto triangle = [](double nearness, const Color& color) {
    return std::array<GridCorner, 3>{
        {{{-10, -10, nearness}, color}, {{40, -10, nearness}, color}, {{-10, 40, nearness}, color}}};
  };
  for (const bool near_first : {true, false}) {
    SampleGrid grid(8);
    if (near_first) grid.draw(triangle(2, Color(1, 0, 0)), 5);
    grid.draw(triangle(1, Color(0, 1, 0)), 6);
    if (!near_first) grid.draw(triangle(2, Color(1, 0, 0)), 5);
    EXPECT_EQ(grid.owner(3, 3), 5u);
    EXPECT_NEAR(grid.color(3, 3).r, 1, 1e-6);
  }
}

}  // namespace
}  // namespace pomona
