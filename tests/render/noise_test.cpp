#include "render/style/noise.h"

#include <cmath>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/random.h"
#include "render/style/style_file.h"

namespace pomona {
namespace {

const RandomStream stream({7, 0}, "noise_test");

glm::dvec3 some_point(std::uint64_t i, double size) {
  return glm::dvec3(stream.uniform(3 * i), stream.uniform(3 * i + 1), stream.uniform(3 * i + 2)) * size - 0.5 * size;
}

NoiseStyle two_keys() {
  NoiseStyle style;
  style.base_frequency = 60;
  style.keys.push_back({Color(0.6f, 0.02f, 0.02f), {0.1, 0.05, 0.02}, {1, 0, 0}});
  style.keys.push_back({Color(0.9f, 0.85f, 0.6f), {0.0, 0.02, 0.0}, {0.5, 0, 0.3}});
  return style;
}

TEST(Noise, StaysWithinOneAndUsesItsRange) {
  double low = 0, high = 0, sum = 0;
  for (std::uint64_t i = 0; i < 50000; ++i) {
    const double n = gradient_noise(some_point(i, 100), 1);
    ASSERT_LE(std::fabs(n), 1.0);
    low = std::min(low, n);
    high = std::max(high, n);
    sum += n;
  }
  EXPECT_LT(low, -0.7);
  EXPECT_GT(high, 0.7);
  EXPECT_NEAR(sum / 50000, 0.0, 0.01);
}

TEST(Noise, IsZeroAtLatticePointsAndDiffersBetweenSeeds) {
  EXPECT_EQ(gradient_noise({3, -5, 11}, 4), 0.0);
  EXPECT_NE(gradient_noise({0.3, 0.4, 0.2}, 1), gradient_noise({0.3, 0.4, 0.2}, 2));
}

TEST(Noise, KnownBits) {
  // The values determine bytes of pictures: they must never change silently.
  EXPECT_EQ(gradient_noise({0.25, 0.5, 0.75}, 0), -0.19422388076782227);
  EXPECT_EQ(gradient_noise({-12.125, 7.5, 0.0625}, 3), 0.19396655451782863);
}

TEST(Noise, IsContinuousEverywhereAroundTheAxisToo) {
  NoiseStyle style = two_keys();
  for (const glm::dvec3& stretch : {glm::dvec3(1), glm::dvec3(0.2, 1, 1), glm::dvec3(1, 0.1, 2)}) {
    style.stretch = stretch;
    for (std::uint64_t i = 0; i < 4000; ++i) {
      // Points near and far from the axis, and on the azimuth's seam at -X.
      glm::dvec3 p = some_point(i, 0.08);
      if (i % 4 == 0) p.z = 0, p.x = -std::fabs(p.x);
      if (i % 4 == 1) p *= glm::dvec3(0.01, 1, 0.01);
      const glm::dvec3 q = p + glm::dvec3(0, 0, i % 2 == 0 ? 1e-8 : -1e-8);
      ASSERT_NEAR(band_noise(style, p, 1), band_noise(style, q, 1), 1e-3) << p.x << " " << p.y << " " << p.z;
    }
  }
}

TEST(Noise, ManyPlacesHaveTheBitsThatEachHasAlone) {
  NoiseStyle style = two_keys();
  for (const glm::dvec3& stretch : {glm::dvec3(1), glm::dvec3(0.2, 1, 1), glm::dvec3(1, 0.1, 2)}) {
    style.stretch = stretch;
    const Modulation modulation(style);
    std::vector<Color> colors;
    std::vector<glm::dvec3> positions;
    std::vector<double> footprints;
    for (std::uint64_t i = 0; i < 1003; ++i) {
      colors.emplace_back(0.6f, 0.02f + 8e-4f * static_cast<float>(i), 0.1f);
      positions.push_back(some_point(i, 0.08));
      footprints.push_back(1e-5 * static_cast<double>(i));  // from all bands to none
    }
    const std::vector<Color> all = modulation(colors, positions, footprints);
    for (std::size_t i = 0; i < all.size(); ++i)
      ASSERT_EQ(modulation(colors[i], positions[i], footprints[i]), all[i]) << i;
  }
}

TEST(Noise, PatternsHaveNothingInCommon) {
  for (const glm::dvec3& stretch : {glm::dvec3(1), glm::dvec3(0.2, 1, 1)}) {
    NoiseStyle drawn = two_keys(), own = drawn, others = drawn;
    drawn.stretch = own.stretch = others.stretch = stretch;
    own.pattern = 77, others.pattern = max_pattern;
    for (const NoiseStyle& other : {drawn, others}) {
      double both = 0, squares = 0;
      for (std::uint64_t i = 0; i < 20000; ++i) {
        const glm::dvec3 p = some_point(i, 0.3);
        both += band_noise(own, p, 1) * band_noise(other, p, 1);
        squares += 0.5 * (std::pow(band_noise(own, p, 1), 2) + std::pow(band_noise(other, p, 1), 2));
      }
      EXPECT_LT(std::fabs(both), 0.05 * squares);
    }
  }
}

TEST(Noise, RunsAlongTheAxisWhenStretchedThere) {
  NoiseStyle style = two_keys();
  style.stretch = {1, 0.05, 1};
  double along = 0, around = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const glm::dvec3 p = some_point(i, 0.02) + glm::dvec3(0.04, 0, 0);
    const double n = band_noise(style, p, 0);
    along += std::fabs(band_noise(style, p + glm::dvec3(0, 0.002, 0), 0) - n);
    around += std::fabs(band_noise(style, p + glm::dvec3(0, 0, 0.002), 0) - n);
  }
  EXPECT_LT(along, 0.2 * around);
}

TEST(Modulation, LeavesColorsAloneWithoutWeights) {
  NoiseStyle style = two_keys();
  for (NoiseKey& key : style.keys) key.weights.assign(3, 0.0);
  for (std::uint64_t i = 0; i < 100; ++i) {
    const Color color(some_point(i, 1) + 0.5);
    EXPECT_EQ(modulated(style, color, some_point(i, 0.1)), color);
    EXPECT_EQ(modulated(NoiseStyle{}, color, some_point(i, 0.1)), color);
  }
}

TEST(Modulation, FollowsTheColor) {
  const Modulation modulation(two_keys());
  double red = 0, pale = 0;
  for (std::uint64_t i = 0; i < 500; ++i) {
    const glm::dvec3 p = some_point(i, 0.1);
    const auto moved = [&](const Color& c) { return glm::distance(to_oklab(modulation(c, p, 0)), to_oklab(c)); };
    red += moved({0.6f, 0.02f, 0.02f});
    pale += moved({0.9f, 0.85f, 0.6f});
  }
  EXPECT_GT(red, 4 * pale);
  EXPECT_GT(pale, 0);
}

TEST(Modulation, FadesOutWhatPixelsCannotShow) {
  const Modulation modulation(two_keys());
  const Color color(0.6f, 0.02f, 0.02f);
  EXPECT_EQ(modulation(color, {0.013, 0.02, 0.031}, 0.5 / 60), color);
  EXPECT_NE(modulation(color, {0.013, 0.02, 0.031}, 0.1 / 240), color);
}

TEST(Modulation, StaysAColor) {
  NoiseStyle style = two_keys();
  style.keys[0].weights = {50, 50, 50};
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Color c = modulated(style, {0.6f, 0.02f, 0.02f}, some_point(i, 0.1));
    for (int k = 0; k < 3; ++k) EXPECT_TRUE(c[k] >= 0 && c[k] <= 1);
  }
}

TEST(Style, IsFoundByName) {
  EXPECT_FALSE(style_named("plain").noise);
  EXPECT_TRUE(style_named("ink").ink);
  try {
    style_named("oil");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::usage);
    EXPECT_THAT(error.diagnostics().front().hint, ::testing::HasSubstr("plain"));
  }
}

}  // namespace
}  // namespace pomona
