// Variants: what differs between them besides curves.
#include "generator/compose/grow.h"

#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "generator/template/read/read_template.h"

namespace pomona {
namespace {

Template shipped(const std::string& name) {
  return read_template(std::filesystem::path(POMONA_SOURCE_DIR) / "templates" / (name + ".toml"));
}

TEST(Grow, EveryVariantHasAPatternOfItsOwn) {
  const Template melon = shipped("melon");
  ASSERT_FALSE(melon.details.empty());
  std::set<std::uint32_t> patterns;
  for (const VariantKey key : {VariantKey{1, 0}, VariantKey{2, 0}, VariantKey{0, 0}, VariantKey{1, 1}}) {
    const Template variant = variant_of(melon, key);
    EXPECT_EQ(variant_of(melon, key).noise.pattern, variant.noise.pattern);
    EXPECT_GE(variant.noise.pattern, 1u);
    EXPECT_LE(variant.noise.pattern, max_pattern);
    for (const DetailSketch& detail : variant.details) EXPECT_EQ(detail.pattern, variant.noise.pattern);
    patterns.insert(variant.noise.pattern);
  }
  EXPECT_EQ(patterns.size(), 4u);
}

/// `--detail` takes no less, and a coarse fruit is no reason to refuse a template: a cabbage of coarse leaves was.
TEST(Grow, EveryShippedTemplateGrowsAtTheSmallestDetail) {
  int grown = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(POMONA_SOURCE_DIR) / "templates")) {
    if (entry.path().extension() != ".toml") continue;
    EXPECT_GT(grow(read_template(entry.path()), {113, 0}, {.detail = 0.1}).sheets.triangle_count(), 20u)
        << entry.path().stem();
    ++grown;
  }
  EXPECT_GT(grown, 50);
}

TEST(Grow, SpotsThatStandOutGoWithTheVariant) {
  Template fruit = shipped("avocado");
  EXPECT_TRUE(grow(fruit, {1, 0}).raised.empty());
  fruit.surfaces[0].front.spots.back().relief = 2e-4;
  const GrownFruit one = grow(fruit, {1, 0}), other = grow(fruit, {2, 0});
  ASSERT_GT(one.raised.size(), 50u);
  EXPECT_EQ(one.raised[0].center, grow(fruit, {1, 0}).raised[0].center);
  EXPECT_NE(one.raised[0].center, other.raised[0].center);
}

/// Seeds ripen like flesh and skin, although they are not surfaces of the sweep.
TEST(Grow, SeedsRipenWithTheirFruit) {
  Template fruit = shipped("strawberry");
  fruit.ripeness.parts.clear();
  for (int part = 0; part < static_cast<int>(fruit.parts.size()); ++part)
    fruit.ripeness.parts.push_back(
        {.part = part, .stops = {{0, Color(0.1f, 0.3f, 0.05f)}, {2, Color(0.2f, 0.05f, 0.02f)}}});
  fruit.individual.ripeness = 0;
  const GrownFruit unripe = grow(fruit, {1, 0});
  ASSERT_FALSE(unripe.grains.triangle.empty());
  fruit.individual.ripeness = 2;
  const GrownFruit ripe = grow(fruit, {1, 0});
  EXPECT_EQ(ripe.grains.position, unripe.grains.position);
  ASSERT_EQ(ripe.grains.front_color.size(), unripe.grains.front_color.size());
  for (std::size_t v = 0; v < ripe.grains.front_color.size(); ++v)
    ASSERT_LT(ripe.grains.front_color[v].g, unripe.grains.front_color[v].g) << v;
}

TEST(Grow, TheDrawingsPatternStaysWhereNothingVaries) {
  EXPECT_EQ(variant_of(shipped("melon"), {5, 0}, {.as_drawn = true, .folds = {}}).noise.pattern, 0u);
  EXPECT_EQ(variant_of(shipped("kidney"), {5, 0}).noise.pattern, 0u);
}

}  // namespace
}  // namespace pomona
