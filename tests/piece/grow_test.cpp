// Variants: what each has of its own besides its curves.
#include "generator/piece/grow.h"

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
    EXPECT_LE(variant.noise.pattern, most_pattern);
    for (const DetailSketch& detail : variant.details) EXPECT_EQ(detail.pattern, variant.noise.pattern);
    patterns.insert(variant.noise.pattern);
  }
  EXPECT_EQ(patterns.size(), 4u);
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

TEST(Grow, TheDrawingsPatternStaysWhereNothingVaries) {
  EXPECT_EQ(variant_of(shipped("melon"), {5, 0}, {.as_drawn = true, .folds = {}}).noise.pattern, 0u);
  EXPECT_EQ(variant_of(shipped("kidney"), {5, 0}).noise.pattern, 0u);
}

}  // namespace
}  // namespace pomona
