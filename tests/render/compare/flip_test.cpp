// FLIP against the authors' own program, and its required properties.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>

#include "generator/base/error.h"
#include "render/compare/flip.h"
#include "render/compare/flip_kernels.h"

namespace pomona {
namespace {

using Paint = std::function<glm::ivec3(int x, int y)>;

Image painted(int width, int height, const Paint& paint) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) image.pixels.emplace_back(paint(x, y));
  }
  return image;
}

Image flat(const glm::ivec3& color) {
  return painted(24, 24, [&](int, int) { return color; });
}

std::uint32_t mixed(int x, int y, int channel) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9E3779B1u ^ static_cast<std::uint32_t>(y) * 0x85EBCA77u ^
                    static_cast<std::uint32_t>(channel) * 0xC2B2AE3Du;
  h ^= h >> 15;
  h *= 0x2C1B3C6Du;
  h ^= h >> 12;
  h *= 0x297A2D39u;
  return (h ^ h >> 15) & 255u;
}

glm::ivec3 disc(int x, int y) {
  const int dx = x - 40, dy = y - 30;
  return dx * dx + dy * dy < 400 ? glm::ivec3(200, 40 + x, 30) : glm::ivec3(245 - y, 240, 225);
}
glm::ivec3 moved_disc(int x, int y) { return disc(x - 1, y); }
glm::ivec3 noise(int x, int y) { return {mixed(x, y, 0), mixed(x, y, 1), mixed(x, y, 2)}; }
glm::ivec3 greener_noise(int x, int y) {
  const glm::ivec3 color = noise(x, y);
  return {color.r, std::min(color.g + 12, 255), color.b};
}
glm::ivec3 ramp(int x, int y) { return {2 * x, 3 * y, x + y}; }
glm::ivec3 swapped_ramp(int x, int y) { return {2 * x, x + y, 3 * y}; }
glm::ivec3 checks(int x, int y) { return glm::ivec3(((x / 4 + y / 4) & 1) * 255); }
glm::ivec3 inverted_checks(int x, int y) { return glm::ivec3(255) - checks(x, y); }

double mean_flip(const Image& reference, const Image& result, double pixels_per_degree = 0) {
  FlipOptions options;
  if (pixels_per_degree > 0) options.pixels_per_degree = pixels_per_degree;
  return mean(flip(reference, result, options));
}

double mean_flip(const Paint& reference, const Paint& result, double pixels_per_degree = 0) {
  return mean_flip(painted(80, 72, reference), painted(80, 72, result), pixels_per_degree);
}

// The figures are from the authors' program (github.com/NVlabs/flip, version 1.6, src/cpp/FLIP.h) in double precision;
// its single precision differs in the fifth digit.
constexpr double agreement = 1e-6;

TEST(Flip, AgreesWithTheAuthorsProgramOnFlatColours) {
  EXPECT_NEAR(mean_flip(flat({0, 0, 0}), flat({255, 255, 255})), 0.9673797633, agreement);
  EXPECT_NEAR(mean_flip(flat({0, 255, 0}), flat({0, 0, 255})), 1, agreement);
  EXPECT_NEAR(mean_flip(flat({0, 255, 0}), flat({255, 0, 0})), 0.9866622751, agreement);
  EXPECT_NEAR(mean_flip(flat({128, 128, 128}), flat({131, 128, 128})), 0.0532757780, agreement);
}

TEST(Flip, AgreesWithTheAuthorsProgramOnPictures) {
  EXPECT_NEAR(mean_flip(disc, moved_disc), 0.0520745537, agreement);
  EXPECT_NEAR(mean_flip(noise, greener_noise), 0.2492076714, agreement);
  EXPECT_NEAR(mean_flip(ramp, swapped_ramp), 0.6119004663, agreement);
  EXPECT_NEAR(mean_flip(checks, inverted_checks), 0.5574027594, agreement);
}

TEST(Flip, AgreesWithTheAuthorsProgramFromNearby) {
  EXPECT_NEAR(mean_flip(disc, moved_disc, 30), 0.0427115471, agreement);
  EXPECT_NEAR(mean_flip(noise, greener_noise, 30), 0.2605119389, agreement);
  EXPECT_NEAR(mean_flip(ramp, swapped_ramp, 30), 0.6046568632, agreement);
  EXPECT_NEAR(mean_flip(checks, inverted_checks, 30), 0.9382619242, agreement);
}

TEST(Flip, AgreesWithTheAuthorsProgramPixelByPixel) {
  const FlipMap map = flip(painted(80, 72, ramp), painted(80, 72, swapped_ramp));
  EXPECT_NEAR(map.error[0], 0.0099943633, agreement);
  EXPECT_NEAR(map.error[36 * 80 + 40], 0.5948221887, agreement);
  const FlipMap other = flip(painted(80, 72, noise), painted(80, 72, greener_noise));
  EXPECT_NEAR(other.error[0], 0.3262707594, agreement);
  EXPECT_NEAR(other.error[36 * 80 + 40], 0.2428074731, agreement);
}

TEST(Flip, IsNothingBetweenEqualPicturesAndTheSameEitherWay) {
  EXPECT_EQ(mean_flip(noise, noise), 0);
  EXPECT_EQ(mean_flip(disc, moved_disc), mean_flip(moved_disc, disc));
}

TEST(Flip, DoesNotDependOnThreadsOrBands) {
  const Image one = painted(50, 200, ramp), other = painted(50, 200, swapped_ramp);
  FlipOptions alone;
  alone.threads.count = 1;
  EXPECT_EQ(flip(one, other, alone).error, flip(one, other).error);

  // Distant pixels do not matter: the rows of a band are the same with and without the rows below.
  const Image upper_one = painted(50, 100, ramp), upper_other = painted(50, 100, swapped_ramp);
  const FlipMap whole = flip(one, other), upper = flip(upper_one, upper_other);
  for (std::size_t i = 0; i < 50u * 80u; ++i) ASSERT_EQ(whole.error[i], upper.error[i]) << i;
}

TEST(Flip, TakesPicturesOfOnePixelAndRefusesDifferentSizes) {
  EXPECT_NEAR(mean_flip(painted(1, 1, [](int, int) { return glm::ivec3(0); }),
                        painted(1, 1, [](int, int) { return glm::ivec3(255); })),
              0.9673797633, agreement);
  EXPECT_THROW(flip(painted(2, 1, ramp), painted(1, 2, ramp)), Error);
}

TEST(FlipKernels, KeepFlatPicturesAndBalanceTheirSigns) {
  const ContrastKernels contrast = contrast_kernels(67);
  const auto sum = [](const Kernel& kernel) {
    double total = 0;
    for (const double weight : kernel) total += weight;
    return total;
  };
  EXPECT_NEAR(sum(contrast.light), 1, 1e-12);
  EXPECT_NEAR(sum(contrast.red_green), 1, 1e-12);
  const double wide = sum(contrast.blue_yellow_wide), narrow = sum(contrast.blue_yellow_narrow);
  EXPECT_NEAR(wide * wide + narrow * narrow, 1, 1e-12);

  const FeatureKernels feature = feature_kernels(67);
  EXPECT_EQ(feature.smooth.size(), static_cast<std::size_t>(2 * feature.radius + 1));
  for (const Kernel* kernel : {&feature.edge, &feature.point}) {
    double positive = 0;
    for (const double weight : *kernel) positive += std::max(weight, 0.0);
    EXPECT_NEAR(positive, 1, 1e-12);
    EXPECT_NEAR(sum(*kernel), 0, 1e-12);
  }
}

}  // namespace
}  // namespace pomona
