#include "render/image/backdrop.h"

#include <cmath>

#include <gtest/gtest.h>

#include "generator/base/color.h"
#include "render/image/sensor.h"

namespace pomona {
namespace {

Image plain(int width, int height, const glm::u8vec3& color) {
  return {width, height, std::vector<glm::u8vec3>(static_cast<std::size_t>(width) * height, color)};
}

TEST(Backdrop, StandsWhereNothingIs) {
  Image picture = plain(3, 1, {255, 255, 255});
  picture.pixels[2] = {10, 200, 30};
  const Image behind = plain(3, 1, {90, 60, 30});
  const Image both = before(picture, {0, 0, 1}, behind);
  EXPECT_EQ(both.at(0, 0), behind.at(0, 0));
  EXPECT_EQ(both.at(2, 0), picture.at(2, 0));
}

TEST(Backdrop, TakesShadowsAndMixesAtRims) {
  // A shadow of half the light; beside it a pixel half of which a black thing covers, in the same shadow.
  const auto half = static_cast<std::uint8_t>(std::lround(255 * srgb_from_linear(0.5)));
  const auto quarter = static_cast<std::uint8_t>(std::lround(255 * srgb_from_linear(0.25)));
  Image picture = plain(2, 1, {half, half, half});
  picture.pixels[1] = {quarter, quarter, quarter};
  const Image both = before(picture, {0, 0.5f}, plain(2, 1, {half, half, half}));
  EXPECT_NEAR(both.at(0, 0).x, quarter, 1);
  EXPECT_NEAR(both.at(1, 0).x, 255 * srgb_from_linear(0.125), 1);
}

TEST(Backdrop, BeforeNothingOnlyShadowsAndThingsAreLeft) {
  const auto half = static_cast<std::uint8_t>(std::lround(255 * srgb_from_linear(0.5)));
  Image picture = plain(3, 1, {255, 255, 255});
  picture.pixels[1] = {half, half, half};
  picture.pixels[2] = {200, 20, 10};
  const TransparentImage alone = before_nothing(picture, {0, 0, 1});
  EXPECT_EQ(alone.opacity[0], 0);
  EXPECT_NEAR(alone.opacity[1], 128, 1);
  EXPECT_EQ(alone.image.at(1, 0), glm::u8vec3(0));
  EXPECT_EQ(alone.opacity[2], 255);
  EXPECT_EQ(alone.image.at(2, 0), picture.at(2, 0));
}

TEST(Backdrop, CropsKeepTheShape) {
  Image ramp{64, 32, {}};
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x) ramp.pixels.emplace_back(4 * x, 8 * y, 0);
  const Image whole = cropped(ramp, 64, 32, {0.3, 0.8}, 1);
  EXPECT_EQ(whole.pixels, ramp.pixels);
  const Image right = cropped(ramp, 16, 16, {1, 0}, 0.5);
  EXPECT_NEAR(right.at(15, 0).x - right.at(0, 0).x, 60, 1);
  EXPECT_GE(right.at(15, 0).x, 250);
}

TEST(Sensor, LeavesAPictureAloneUnlessAsked) {
  const Image picture = plain(8, 8, {100, 150, 200});
  EXPECT_EQ(sensed(picture, {}).pixels, picture.pixels);
}

TEST(Sensor, ExposesByStops) {
  const Image picture = plain(1, 1, {100, 100, 100});
  const double light = from_srgb8(picture.at(0, 0)).x;
  EXPECT_NEAR(from_srgb8(sensed(picture, {.exposure = 1}).at(0, 0)).x, 2 * light, 0.01);
}

TEST(Sensor, BlursWithoutLosingLight) {
  Image picture = plain(41, 41, {0, 0, 0});
  picture.pixels[20 * 41 + 20] = {255, 255, 255};
  picture.pixels[20 * 41 + 21] = {255, 255, 255};
  const Image soft = sensed(picture, {.blur = 1});
  double sum = 0;
  for (const glm::u8vec3& pixel : soft.pixels) sum += from_srgb8(pixel).x;
  EXPECT_NEAR(sum, 2, 0.05);
  EXPECT_LT(soft.at(20, 20).x, 255);
  EXPECT_EQ(soft.at(20, 20), soft.at(21, 20));
}

TEST(Sensor, NoiseHasTheDeviationAsked) {
  const Image grey = plain(200, 200, {188, 188, 188});
  const SensorOptions noisy{.noise = 0.05, .key = {1, 2}};
  const Image seen = sensed(grey, noisy);
  EXPECT_EQ(sensed(grey, noisy).pixels, seen.pixels);
  EXPECT_NE(sensed(grey, {.noise = 0.05, .key = {1, 3}}).pixels, seen.pixels);
  const double light = from_srgb8(grey.at(0, 0)).x;
  double sum = 0, squares = 0;
  for (const glm::u8vec3& pixel : seen.pixels) {
    const double off = from_srgb8(pixel).y - light;
    sum += off;
    squares += off * off;
  }
  const double count = 200.0 * 200;
  EXPECT_NEAR(sum / count, 0, 0.002);
  EXPECT_NEAR(std::sqrt(squares / count), 0.05 * std::sqrt(0.2 + 0.8 * light), 0.002);
}

}  // namespace
}  // namespace pomona
