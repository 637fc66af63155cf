// Solids keep their texels when they share a page.
#include "render/texture/texture_pages.h"

#include <gtest/gtest.h>
#include <bit>

#include "render/style/style_file.h"
#include "render/texture/uv_atlas.h"
#include "tests/render/half_ball.h"

namespace pomona {
namespace {

bool overlap(const glm::ivec2& a, const glm::ivec2& size_a, const glm::ivec2& b, const glm::ivec2& size_b) {
  return a.x < b.x + size_b.x && b.x < a.x + size_a.x && a.y < b.y + size_b.y && b.y < a.y + size_a.y;
}

void expect_apart(const PageLayout& layout, const std::vector<glm::ivec2>& sizes) {
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (sizes[i].x == 0) continue;
    const PageLayout::Place& place = layout.of_texture[i];
    const glm::ivec2 page = layout.pages.at(place.page);
    EXPECT_TRUE(std::has_single_bit(static_cast<unsigned>(page.x)) && page.x <= max_texture_side);
    EXPECT_LE(place.corner.x + sizes[i].x, page.x);
    EXPECT_LE(place.corner.y + sizes[i].y, page.y);
    EXPECT_EQ(place.corner % 8, glm::ivec2(0)) << "blocks of mip levels";
    for (std::size_t k = 0; k < i; ++k) {
      const PageLayout::Place& other = layout.of_texture[k];
      if (sizes[k].x == 0 || other.page != place.page) continue;
      EXPECT_FALSE(overlap(place.corner, sizes[i], other.corner, sizes[k])) << i << " and " << k;
    }
  }
}

TEST(TexturePages, KeepTexturesApart) {
  std::vector<glm::ivec2> sizes;
  for (const int side : {256, 64, 100, 0, 512, 64, 256, 65, 128, 256}) {
    sizes.emplace_back(side, side);
    sizes.emplace_back(2 * side, side);
  }
  const PageLayout layout = page_layout(sizes);
  EXPECT_EQ(layout.pages.size(), 1u);
  expect_apart(layout, sizes);
}

TEST(TexturePages, AreFullWhereSidesArePowersOfTwo) {
  const std::vector<glm::ivec2> sizes(64, glm::ivec2(256));
  EXPECT_EQ(page_layout(sizes).pages, std::vector<glm::ivec2>{glm::ivec2(2048)});
  EXPECT_EQ(page_layout(std::vector<glm::ivec2>(101, glm::ivec2(256))).pages,
            std::vector<glm::ivec2>{glm::ivec2(4096, 2048)});
}

TEST(TexturePages, AreSeveralWhereOneIsTooSmall) {
  const std::vector<glm::ivec2> sizes{glm::ivec2(4096), glm::ivec2(8192), glm::ivec2(2048), glm::ivec2(8192)};
  const PageLayout layout = page_layout(sizes);
  EXPECT_EQ(layout.pages.size(), 3u);
  expect_apart(layout, sizes);
}

TEST(TexturePages, HoldTheTexelsThatSolidsHad) {
  std::vector<BakedSolid> alone;
  for (const int side : {128, 64, 256, 64}) {
    alone.push_back(
        baked(named::half_ball(24, 6), style_named("plain"), {.texels = side, .maps = Maps::all, .looks = true}));
  }
  alone.emplace_back();  // without triangles
  std::vector<const BakedSolid*> all;
  std::vector<glm::ivec2> sizes;
  for (const BakedSolid& solid : alone) {
    all.push_back(&solid);
    sizes.emplace_back(solid.texture.width, solid.texture.height);
  }
  const PageLayout layout = page_layout(sizes);
  const std::vector<BakedSolid> paged = on_pages(all, layout, "atlas");
  ASSERT_EQ(paged.size(), alone.size());
  EXPECT_EQ(paged.back().page, nullptr);
  for (std::size_t i = 0; i + 1 < alone.size(); ++i) {
    const BakedSolid &own = alone[i], &shared = paged[i];
    ASSERT_NE(shared.page, nullptr);
    EXPECT_EQ(shared.page, paged[0].page);
    EXPECT_EQ(shared.page->name, "atlas");
    EXPECT_TRUE(shared.page->maps.tell_looks);
    const glm::ivec2 corner = layout.of_texture[i].corner;
    for (int y = 0; y < sizes[i].y; ++y) {
      for (int x = 0; x < sizes[i].x; ++x) {
        ASSERT_EQ(shared.page->texture.at(corner.x + x, corner.y + y), own.texture.at(x, y));
        ASSERT_EQ(shared.page->maps.orm.at(corner.x + x, corner.y + y), own.maps.orm.at(x, y));
      }
    }
    const glm::dvec2 page(shared.page->texture.width, shared.page->texture.height);
    ASSERT_EQ(shared.uv.size(), own.uv.size());
    for (std::size_t v = 0; v < own.uv.size(); ++v) {
      const glm::dvec2 texel = glm::dvec2(shared.uv[v]) * page - glm::dvec2(corner);
      const glm::dvec2 expected = glm::dvec2(own.uv[v]) * glm::dvec2(sizes[i]);
      ASSERT_NEAR(texel.x, expected.x, 1e-3);
      ASSERT_NEAR(texel.y, expected.y, 1e-3);
    }
    EXPECT_EQ(shared.maps.tangent, own.maps.tangent);
  }
}

}  // namespace
}  // namespace pomona
