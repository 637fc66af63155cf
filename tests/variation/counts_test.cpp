// Varying numbers of folds and surfaces, and independent random numbers of species.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include "generator/surface/shells.h"
#include "generator/surface/sweep/sweep.h"
#include "generator/template/read/read_template.h"
#include "generator/variation/species_key.h"
#include "generator/variation/variation.h"
#include "generator/variation/vary.h"
#include "tests/variation/fruits.h"

namespace pomona {
namespace {

Template shipped(const std::string& name) { return read_template(POMONA_SOURCE_DIR "/templates/" + name + ".toml"); }

/// The tests' tomato with varying numbers: surface 3 is its chambers, surface 2 its core.
Template counted_tomato(CountVariation counts) {
  Template fruit = fruits::tomato(5);
  fruit.name = "counted";
  fruit.variation.counts = std::move(counts);
  return fruit;
}

std::size_t surface_called(const Template& fruit, const std::string& name) {
  const auto found = std::find_if(fruit.surfaces.begin(), fruit.surfaces.end(),
                                  [&](const SurfaceSketch& surface) { return surface.name == name; });
  return static_cast<std::size_t>(found - fruit.surfaces.begin());
}

int loops_of(const SurfaceSketch& surface) {
  return static_cast<int>(std::count_if(surface.horizontal.begin(), surface.horizontal.end(),
                                        [](const Curve& loop) { return !loop.points.empty(); }));
}

int chambers_of(const Template& fruit) { return static_cast<int>(surface_called(fruit, "chamber")); }

TEST(SpeciesKey, TellsSpeciesApartAndKeepsTheFruitAsDrawn) {
  std::set<std::pair<std::uint64_t, std::uint64_t>> keys;
  for (const char* species : {"apple", "fig", "kiwi"}) {
    const VariantKey drawn = species_key({0, 0}, species);
    EXPECT_EQ(drawn.seed, 0u);
    EXPECT_EQ(drawn.index, 0u);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      for (std::uint64_t index = 0; index < 20; ++index) {
        if (seed + index == 0) continue;
        const VariantKey key = species_key({seed, index}, species);
        keys.insert({key.seed, key.index});
      }
    }
  }
  EXPECT_EQ(keys.size(), 3u * (20 * 20 - 1));
}

TEST(SpeciesKey, GoesByTheNameNotByThePathOrWhatIsDrawn) {
  Template fruit = fruits::tomato(5), renamed = fruit, moved = fruit;
  fruit.name = moved.name = "tomato";
  renamed.name = "rename";
  moved.file = "/elsewhere/other.toml";
  moved.title = "Another";
  const auto positions = [](const Template& of) { return sweep(vary(of, {3, 0})).position; };
  EXPECT_EQ(positions(fruit), positions(moved));
  EXPECT_NE(positions(fruit), positions(renamed));
}

/// Pearson's correlation of two series.
double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  double ma = 0, mb = 0, ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) ma += a[i] / n, mb += b[i] / n;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - ma) * (b[i] - mb);
    aa += (a[i] - ma) * (a[i] - ma);
    bb += (b[i] - mb) * (b[i] - mb);
  }
  return ab / std::sqrt(aa * bb);
}

/// bench/variants tests all species over a thousand seeds. With 40 seeds, chance gives 0.6 for one pair in 10 000.
TEST(Species, AreNotOfOneSizeOrFormAtEqualSeeds) {
  constexpr std::uint64_t seeds = 40;
  std::vector<std::vector<double>> sizes, forms;
  for (const char* name : {"star_fruit", "fig", "watermelon", "pepper"}) {
    const Variation variation(shipped(name));
    std::vector<double>&size = sizes.emplace_back(), &form = forms.emplace_back();
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const glm::dvec3 sides = bounds_of(sweep(variation.draw({seed, 0}).fruit)).size();
      size.push_back(std::log(glm::length(sides)));
      form.push_back(std::log(sides.y / std::max(sides.x, sides.z)));
    }
  }
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_LT(std::abs(correlation(sizes[i], sizes[j])), 0.6);
      EXPECT_LT(std::abs(correlation(forms[i], forms[j])), 0.6);
    }
  }
}

TEST(Counts, FoldsAreSeenAsOftenAsTheTemplateSays) {
  const Template fruit = counted_tomato({.folds = {{4, 0.25}, {5, 0.6}, {6, 0.15}}, .present = {}});
  const Variation variation(fruit);
  std::map<int, int> seen;
  constexpr int draws = 200;
  for (std::uint64_t seed = 1; seed <= draws; ++seed) ++seen[fold_count(variation.draw({seed, 0}).fruit)];
  // Four standard deviations of a binomial.
  const auto expect_share = [&](int folds, double share) {
    EXPECT_NEAR(seen[folds], share * draws, 4 * std::sqrt(share * (1 - share) * draws)) << folds;
  };
  expect_share(4, 0.25);
  expect_share(5, 0.6);
  expect_share(6, 0.15);
  EXPECT_EQ(seen.size(), 3u);
}

TEST(Counts, AFixedNumberOfFoldsIsKept) {
  const Variation variation(counted_tomato({.folds = {{4, 0.5}, {6, 0.5}}, .present = {}}));
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    EXPECT_EQ(fold_count(variation.draw({seed, 0}, {.folds = 3}).fruit), 3);
    EXPECT_EQ(fold_count(variation.draw({seed, 0}, {.drawn_counts = true}).fruit), 5);
    EXPECT_EQ(fold_count(variation.draw({seed, 0}, {.curves_only = true}).fruit), 5);
    EXPECT_EQ(fold_count(variation.draw({seed, 0}, {.amount = 0}).fruit), 5);
  }
}

TEST(Counts, SomeFoldsLackWhatNotAllHave) {
  Template fruit = fruits::tomato(5);
  const int chamber = chambers_of(fruit);
  fruit = counted_tomato({.folds = {}, .present = {{chamber, 0.6}}});
  const Variation variation(fruit);
  int chambers = 0;
  std::set<std::vector<bool>> patterns;
  constexpr int draws = 100;
  for (std::uint64_t seed = 1; seed <= draws; ++seed) {
    const Template variant = variation.draw({seed, 0}).fruit;
    std::vector<bool> pattern;
    for (const Curve& loop : variant.surfaces[static_cast<std::size_t>(chamber)].horizontal) {
      pattern.push_back(!loop.points.empty());
    }
    EXPECT_EQ(pattern.size(), 5u);
    chambers += loops_of(variant.surfaces[static_cast<std::size_t>(chamber)]);
    patterns.insert(pattern);
    const DiffusionSurfaces swept = sweep(variant);
    EXPECT_THAT(find_shells(swept).closed, testing::Each(1));
  }
  EXPECT_NEAR(chambers, 0.6 * 5 * draws, 4 * std::sqrt(0.24 * 5 * draws));
  EXPECT_GT(patterns.size(), 15u);  // of 32
}

/// The drawn persimmon has seeds in three of its eight chambers; in variants any chamber may have one.
TEST(Counts, FoldsMayHaveWhatTheDrawnOnesLack) {
  const Template fruit = shipped("persimmon");
  const std::size_t seed_surface = surface_called(fruit, "seed");
  const SurfaceSketch& drawn = fruit.surfaces[seed_surface];
  const Variation variation(fruit);
  std::vector<int> borne(8, 0);
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Template variant = variation.draw({seed, 0}).fruit;
    for (std::size_t k = 0; k < 8; ++k) borne[k] += !variant.surfaces[seed_surface].horizontal[k].points.empty();
  }
  EXPECT_LT(loops_of(drawn), 8);
  EXPECT_THAT(borne, testing::Each(testing::Gt(0)));
}

TEST(Counts, ALayerIsThereInSomeFruitsOnly) {
  const Template fruit = shipped("beetroot");
  const std::size_t ring = surface_called(fruit, "sixth-ring");
  const Variation variation(fruit);
  std::set<int> loops;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Template variant = variation.draw({seed, 0}).fruit;
    loops.insert(loops_of(variant.surfaces[ring]));
    const DiffusionSurfaces swept = sweep(variant);
    const bool is_swept = std::count(swept.surface.begin(), swept.surface.end(), static_cast<int>(ring)) > 0;
    EXPECT_EQ(is_swept, loops_of(variant.surfaces[ring]) == 1);
    EXPECT_EQ(swept.surface_names[ring], "sixth-ring");
  }
  EXPECT_THAT(loops, testing::ElementsAre(0, 1));
}

/// Promised in docs/reference/variation.md.
TEST(Counts, FourTemplatesKeepTheirFacesAtAllSeeds) {
  for (const char* name : {"tomato", "onion", "strawberry", "okra"}) {
    const Template fruit = shipped(name);
    const DiffusionSurfaces drawn = sweep(fruit);
    const Variation variation(fruit);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const DiffusionSurfaces swept = sweep(variation.draw({seed, 0}).fruit);
      EXPECT_EQ(swept.triangle, drawn.triangle) << name;
      EXPECT_EQ(swept.surface, drawn.surface) << name;
    }
  }
}

TEST(Counts, EqualCountsMakeEqualTriangles) {
  const Variation variation(shipped("star_fruit"));
  std::map<std::vector<int>, std::vector<glm::uvec3>> known;
  int again = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Template variant = variation.draw({seed, 0}).fruit;
    std::vector<int> counts{fold_count(variant)};
    for (const SurfaceSketch& surface : variant.surfaces) counts.push_back(loops_of(surface));
    const auto [entry, is_new] = known.try_emplace(counts, sweep(variant).triangle);
    if (is_new) continue;
    EXPECT_EQ(sweep(variant).triangle, entry->second);
    ++again;
  }
  EXPECT_GT(again, 0);
}

}  // namespace
}  // namespace pomona
