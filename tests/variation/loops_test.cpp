// Cylindrical variation.
#include <cmath>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include "generator/base/units.h"
#include "generator/variation/polar_curve.h"
#include "generator/variation/texture_synthesis.h"
#include "generator/variation/vary.h"
#include "generator/variation/vary_loops.h"
#include "tests/variation/fruits.h"

namespace pomona {
namespace {

const Curve& loop_of(const Template& fruit, std::size_t surface = 0) {
  return fruit.surfaces[surface].horizontal.front();
}

std::vector<double> radii(const Curve& loop, int count = 360) {
  const RadiusOf radius_of(loop);
  std::vector<double> result;
  for (int i = 0; i < count; ++i) result.push_back(radius_of(2 * pi * i / count));
  return result;
}

/// Root mean square difference of radii at the best turn, over the mean radius.
double deviation(const Curve& a, const Curve& b) {
  const std::vector<double> ra = radii(a), rb = radii(b);
  const std::size_t n = ra.size();
  double mean = 0, best = 1e9;
  for (const double r : ra) mean += r / static_cast<double>(n);
  for (std::size_t shift = 0; shift < n; ++shift) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += (ra[i] - rb[(i + shift) % n]) * (ra[i] - rb[(i + shift) % n]);
    best = std::min(best, std::sqrt(sum / static_cast<double>(n)) / mean);
  }
  return best;
}

std::vector<CyclicSignal> wavy_channels() {
  CyclicSignal wave, other;
  for (int i = 0; i < 256; ++i) {
    const double t = 2 * pi * i / 256;
    wave.push_back(std::cos(3 * t) + 0.5 * std::sin(11 * t) + 0.2 * std::sin(23 * t) * std::cos(t));
    other.push_back(std::sin(5 * t + 1));
  }
  return {wave, other};
}

TEST(LaplacianPyramid, IsPutTogetherAgain) {
  const CyclicSignal wave = wavy_channels().front();
  const CyclicSignal again = compose(decompose(wave));
  for (std::size_t i = 0; i < wave.size(); ++i) EXPECT_NEAR(again[i], wave[i], 1e-14);
}

TEST(TextureSynthesis, AlwaysFindsACandidate) {
  for (const double threshold : {0.0, 0.1, 0.3, 0.7, 1.0, 2.0}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const SourceMap map = draw_source_map(wavy_channels(), {seed, 0}, {.threshold = threshold, .smooth_levels = 0});
      EXPECT_GE(map.fewest_candidates, 1u);
    }
  }
}

TEST(TextureSynthesis, OnlyTurnsTheSampleAtThresholdZero) {
  const SourceMap map =
      draw_source_map(wavy_channels(), {3, 1}, {.threshold = 0, .smooth_levels = 0, .mix_turns = false});
  const std::size_t shift = map.level[0][0];
  for (std::size_t i = 0; i < 256; ++i) EXPECT_EQ(map.level[0][i], (i + shift) % 256);
}

/// The same noise twice, the second time with small changes: at every level the two halves are about equally similar.
CyclicSignal nearly_repeated(double difference) {
  const RandomStream random({7, 0}, "test");
  CyclicSignal signal(256);
  for (std::size_t i = 0; i < 256; ++i) signal[i] = random.normal(i % 128) + difference * random.normal(1000 + i);
  return signal;
}

/// The share of a level's values that come from the other half than their parent.
double share_that_changes_halves(const SourceMap& map, std::size_t level) {
  const std::size_t n = map.level[level].size();
  double changed = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t natural = 2 * map.level[level + 1][i / 2] + i % 2;
    changed += (map.level[level][i] < n / 2) != (natural < n / 2) ? 1 : 0;
  }
  return changed / static_cast<double>(n);
}

/// The threshold is a mean over all coarser levels: what is similar enough at each of them is similar enough at all.
TEST(TextureSynthesis, ChoosesAsFreelyAtTheFinestLevelAsAtCoarserOnes) {
  double coarse = 0, fine = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const SourceMap map = draw_source_map({nearly_repeated(0.15)}, {seed, 0}, {.threshold = 0.35, .smooth_levels = 0});
    coarse += share_that_changes_halves(map, map.level.size() - 3) / 10;
    fine += share_that_changes_halves(map, 0) / 10;
  }
  EXPECT_GT(coarse, 0.3);
  EXPECT_GT(fine, 0.3);
}

TEST(CylindricalVariation, IsAsDrawnUpToATurnAtAmountZero) {
  const Template onion = fruits::onion();
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Template variant = vary(onion, {seed, 0}, {.amount = 0});
    for (std::size_t s = 0; s < onion.surfaces.size(); ++s) {
      EXPECT_LT(deviation(loop_of(onion, s), loop_of(variant, s)), 2e-3) << s;
    }
  }
}

TEST(CylindricalVariation, LeavesACircleACircle) {
  Template onion = fruits::onion(1);
  for (glm::dvec2& p : onion.surfaces[0].horizontal[0].points) p = glm::normalize(p) * 0.03;
  for (const double amount : {0.0, 1.0, 2.0}) {
    for (const double r : radii(loop_of(vary(onion, {7, 0}, {.amount = amount})))) EXPECT_NEAR(r, 0.03, 0.03 * 5e-4);
  }
}

TEST(CylindricalVariation, DepartsFurtherWithTheAmount) {
  const Template onion = fruits::onion();
  double before = -1;
  for (const double amount : {0.0, 0.3, 1.0, 2.0}) {
    double sum = 0;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      sum += deviation(loop_of(onion), loop_of(vary(onion, {seed, 0}, {.amount = amount})));
    }
    EXPECT_GT(sum, before);
    before = sum;
  }
}

TEST(CylindricalVariation, BeyondOneTheSwingsGrowWhereTheyAre) {
  // Deviations at amount 2 are half as large again as at 1, about the same mean, at the same azimuths.
  const LoopVariation variation(fruits::onion(1));
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Template once = variation.draw({seed, 0}, 1), twice = variation.draw({seed, 0}, 2);
    const std::vector<glm::dvec2>&p = loop_of(once).points, &q = loop_of(twice).points;
    ASSERT_EQ(p.size(), q.size());
    double mean_p = 0, mean_q = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      mean_p += std::log(glm::length(p[i])) / static_cast<double>(p.size());
      mean_q += std::log(glm::length(q[i])) / static_cast<double>(p.size());
    }
    EXPECT_NEAR(mean_p, mean_q, 1e-9);
    for (std::size_t i = 0; i < p.size(); ++i) {
      EXPECT_NEAR(glm::distance(glm::normalize(p[i]), glm::normalize(q[i])), 0, 1e-9);
      EXPECT_NEAR(std::log(glm::length(q[i])) - mean_q, 1.5 * (std::log(glm::length(p[i])) - mean_p), 1e-9);
    }
  }
}

TEST(CylindricalVariation, ClosesWithoutAJump) {
  const LoopVariation variation(fruits::onion(3));
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Template variant = variation.draw({seed, 0}, 1);
    for (const SurfaceSketch& surface : variant.surfaces) {
      const std::vector<glm::dvec2>& p = surface.horizontal.front().points;
      double longest = 0;
      for (std::size_t i = 0; i + 1 < p.size(); ++i) longest = std::max(longest, glm::distance(p[i], p[i + 1]));
      EXPECT_LE(glm::distance(p.back(), p.front()), 1.5 * longest);
    }
  }
}

TEST(CylindricalVariation, KeepsLoopsStarShapedAndLayersApart) {
  const Template onion = fruits::onion();
  const LoopVariation variation(onion);
  for (const double amount : {1.0, 2.0}) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const Template variant = variation.draw({seed, 4}, amount);
      std::vector<double> outside;
      for (const SurfaceSketch& surface : variant.surfaces) {
        EXPECT_TRUE(is_star_shaped(surface.horizontal.front()));
        EXPECT_TRUE(is_simple(surface.horizontal.front()));
        const std::vector<double> radius = radii(surface.horizontal.front(), 360);
        for (std::size_t i = 0; i < outside.size(); ++i) EXPECT_LT(radius[i], outside[i]) << seed;
        outside = radius;
      }
    }
  }
}

TEST(CylindricalVariation, KeepsCurlyLoopsSimple) {
  const Template curly = fruits::curly();
  const LoopVariation variation(curly);
  ASSERT_TRUE(is_simple(loop_of(curly)));
  ASSERT_FALSE(is_star_shaped(loop_of(curly)));
  for (std::uint64_t seed = 0; seed < 40; ++seed) EXPECT_TRUE(is_simple(loop_of(variation.draw({seed, 0}, 1)))) << seed;
}

TEST(CylindricalVariation, DependsOnTheKeyAlone) {
  const Template onion = fruits::onion();
  const Template first = vary(onion, {5, 6}), again = vary(onion, {5, 6});
  for (std::size_t s = 0; s < onion.surfaces.size(); ++s) {
    EXPECT_EQ(loop_of(first, s).points, loop_of(again, s).points);
    EXPECT_NE(loop_of(first, s).points, loop_of(vary(onion, {6, 6}), s).points);
    EXPECT_NE(loop_of(first, s).points, loop_of(vary(onion, {5, 7}), s).points);
  }
}

TEST(CylindricalVariation, LeavesWhatDoesNotVary) {
  Template onion = fruits::onion();
  onion.surfaces[2].varies = false;
  const Template variant = vary(onion, {1, 1});
  EXPECT_EQ(loop_of(variant, 2).points, loop_of(onion, 2).points);
  EXPECT_NE(loop_of(variant, 1).points, loop_of(onion, 1).points);
}

}  // namespace
}  // namespace pomona
