#include "render/image/environment.h"

#include <cmath>

#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "generator/base/units.h"

namespace pomona {
namespace {

constexpr int width = 128, height = 64;
constexpr double degree = pi / 180;

/// Grey above the horizon, black below.
Image overcast() {
  Image picture{width, height, std::vector<glm::u8vec3>(static_cast<std::size_t>(width) * height, glm::u8vec3(0))};
  for (int i = 0; i < width * height / 2; ++i) picture.pixels[static_cast<std::size_t>(i)] = glm::u8vec3(100);
  return picture;
}

/// With a white square around a column and a row.
Image with_lamp(int column, int row) {
  Image picture = overcast();
  for (int y = row - 2; y < row + 2; ++y)
    for (int x = column - 2; x < column + 2; ++x)
      picture.pixels[static_cast<std::size_t>(y) * width + x] = glm::u8vec3(255);
  return picture;
}

TEST(Environment, OvercastHasNoLamp) {
  const EnvironmentLight light = light_of(overcast());
  EXPECT_EQ(light.strength, 0);
  EXPECT_NEAR(light.ambient, 1.2 / 0.5, 1e-9) << "as bright as the usual light, all of it from all sides";
  EXPECT_NEAR(light.tint.r, 1, 1e-5);
}

/// The middle column is -Z, +X is to the right of it.
TEST(Environment, ALampIsWhereItStandsInThePicture) {
  struct Case {
    int column;
    double azimuth;
  };
  for (const Case& lamp :
       {Case{width / 2, 180 * degree}, Case{3 * width / 4, 90 * degree}, Case{width / 4, -90 * degree}}) {
    const EnvironmentLight light = light_of(with_lamp(lamp.column, height / 4));
    EXPECT_NEAR(std::abs(std::remainder(light.azimuth - lamp.azimuth, 2 * pi)), 0, 0.01);
    EXPECT_NEAR(light.elevation, 45 * degree, 0.01);
    EXPECT_GT(light.strength, 0.01);
    EXPECT_LT(light.softness, 0.2);
  }
}

/// Both together are as bright as the usual light, whatever the exposure of the picture.
TEST(Environment, ALargerLampLeavesLessLightFromAllSides) {
  Image large = with_lamp(64, 16);
  for (int y = 10; y < 20; ++y)
    for (int x = 50; x < 80; ++x) large.pixels[static_cast<std::size_t>(y) * width + x] = glm::u8vec3(255);
  const EnvironmentLight small_lamp = light_of(with_lamp(64, 16)), large_lamp = light_of(large);
  EXPECT_GT(large_lamp.strength, 2 * small_lamp.strength);
  EXPECT_GT(large_lamp.softness, small_lamp.softness);
  EXPECT_NEAR(0.7 * large_lamp.strength + 0.5 * large_lamp.ambient, 1.2, 1e-9);
}

TEST(Environment, ColouredLightTints) {
  Image warm = overcast();
  for (glm::u8vec3& pixel : warm.pixels) pixel = {pixel.r, pixel.r / 2, 0};
  const Color tint = light_of(warm).tint;
  EXPECT_GT(tint.r, 1.5f);
  EXPECT_EQ(tint.b, 0);
  EXPECT_NEAR(0.2126f * tint.r + 0.7152f * tint.g + 0.0722f * tint.b, 1, 1e-5) << "as bright as white";
}

TEST(Environment, TheCameraSeesWhatItLooksAt) {
  // Towards -Z, level: the lamp at the right edge of the picture's middle, and up is up.
  const Image picture = with_lamp(width / 2, height / 4);
  const double up = 45 * degree;
  const CameraAxes raised{{1, 0, 0}, {0, std::cos(up), std::sin(up)}, {0, -std::sin(up), std::cos(up)}};
  const Image at_lamp = seen_around(picture, raised, 0.2, 9, 9);
  EXPECT_EQ(at_lamp.at(4, 4), glm::u8vec3(255));
  const Image level = seen_around(picture, {}, 1, 9, 9);
  EXPECT_EQ(level.at(4, 0), glm::u8vec3(100));
  EXPECT_EQ(level.at(4, 8), glm::u8vec3(0));
}

TEST(Environment, PicturesOfAnotherShapeAreRefused) {
  EXPECT_THROW(check_environment({8, 8, std::vector<glm::u8vec3>(64)}, "square.png"), Error);
  EXPECT_NO_THROW(check_environment(overcast(), "sky.png"));
}

}  // namespace
}  // namespace pomona
