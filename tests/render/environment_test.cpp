#include "render/image/environment.h"

#include <cmath>

#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "generator/base/units.h"
#include "render/image/hdr.h"
#include "render/image/png.h"

namespace pomona {
namespace {

constexpr int width = 128, height = 64;
constexpr double degree = pi / 180;

LinearImage linear(const Image& picture) { return {picture.width, picture.height, linear_pixels(picture)}; }

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
  const EnvironmentLight light = light_of(linear(overcast()));
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
    const EnvironmentLight light = light_of(linear(with_lamp(lamp.column, height / 4)));
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
  const EnvironmentLight small_lamp = light_of(linear(with_lamp(64, 16))), large_lamp = light_of(linear(large));
  EXPECT_GT(large_lamp.strength, 2 * small_lamp.strength);
  EXPECT_GT(large_lamp.softness, small_lamp.softness);
  EXPECT_NEAR(0.7 * large_lamp.strength + 0.5 * large_lamp.ambient, 1.2, 1e-9);
}

TEST(Environment, ColouredLightTints) {
  Image warm = overcast();
  for (glm::u8vec3& pixel : warm.pixels) pixel = {pixel.r, pixel.r / 2, 0};
  const Color tint = light_of(linear(warm)).tint;
  EXPECT_GT(tint.r, 1.5f);
  EXPECT_EQ(tint.b, 0);
  EXPECT_NEAR(0.2126f * tint.r + 0.7152f * tint.g + 0.0722f * tint.b, 1, 1e-5) << "as bright as white";
}

TEST(Environment, TheCameraSeesWhatItLooksAt) {
  // Towards -Z, level: the lamp at the right edge of the picture's middle, and up is up.
  const LinearImage picture = linear(with_lamp(width / 2, height / 4));
  const double up = 45 * degree;
  const CameraAxes raised{{1, 0, 0}, {0, std::cos(up), std::sin(up)}, {0, -std::sin(up), std::cos(up)}};
  const Image at_lamp = seen_around(picture, raised, 0.2, 9, 9);
  EXPECT_EQ(at_lamp.at(4, 4), glm::u8vec3(255));
  const Image level = seen_around(picture, {}, 1, 9, 9);
  EXPECT_EQ(level.at(4, 0), glm::u8vec3(100));
  EXPECT_EQ(level.at(4, 8), glm::u8vec3(0));
}

TEST(Environment, PicturesOfAnotherShapeAreRefused) {
  const Image square{8, 8, std::vector<glm::u8vec3>(64)};
  EXPECT_THROW(read_environment(write_png(square), "square.png"), Error);
  EXPECT_EQ(read_environment(write_png(overcast()), "sky.png").width, width);
}

const std::string hdr_head = "#?RADIANCE\n# a comment\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2\n\n";

std::string size_line(int rows, int columns) {
  return "-Y " + std::to_string(rows) + " +X " + std::to_string(columns) + "\n";
}

/// A pixel of an .hdr: light of 128 parts of `exponent`, 129 for 1.
std::string rgbe(int red, int green, int blue, int exponent) {
  std::string bytes;
  for (const int value : {red, green, blue, exponent}) bytes.push_back(static_cast<char>(value));
  return bytes;
}

/// Light of 1 everywhere above the horizon but for one pixel of the first row, black below.
std::string hdr_sky(int columns, const std::string& lamp) {
  std::string bytes = hdr_head + size_line(columns / 2, columns);
  for (int y = 0; y < columns / 2; ++y)
    for (int x = 0; x < columns; ++x)
      bytes += y == 0 && x == 0 ? lamp : y < columns / 4 ? rgbe(128, 128, 128, 129) : rgbe(0, 0, 0, 0);
  return bytes;
}

TEST(Hdr, AllCodingsOfRowsAreRead) {
  // Eight pixels: 1, then seven of (2, 1, 0.5).
  const Color one(1), other(2, 1, 0.5f);
  const std::string first = rgbe(128, 128, 128, 129), next = rgbe(128, 64, 32, 130);
  std::string plain = first, repeated = first + next + rgbe(1, 1, 1, 6), runs = rgbe(2, 2, 0, 8);
  for (int i = 0; i < 7; ++i) plain += next;
  for (const auto& [at_first, then] : {std::pair(128, 128), {128, 64}, {128, 32}, {129, 130}}) {
    for (const int value : {1, at_first, 128 + 7, then}) runs.push_back(static_cast<char>(value));
  }
  for (const std::string& row : {plain, repeated, runs}) {
    const LinearImage picture = read_hdr(hdr_head + size_line(2, 8) + row + row, "x.hdr");
    ASSERT_EQ(picture.pixels.size(), 16u);
    for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(picture.pixels[i], i % 8 == 0 ? one : other) << i;
  }
}

TEST(Hdr, WhatIsDamagedIsToldWithItsByte) {
  const std::string row = rgbe(2, 2, 0, 8);
  for (const std::string& wrong :
       {std::string("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n") + size_line(2, 4), hdr_head, hdr_head + "+Y 2 +X 4\n",
        hdr_head + size_line(2, 4), hdr_head + size_line(0, 4), hdr_head + size_line(8192, 16384),
        hdr_head + size_line(4, 8) + rgbe(2, 2, 0, 9), hdr_head + size_line(4, 8) + row + std::string(1, '\x89'),
        hdr_head + size_line(4, 8) + row + std::string(1, '\0'), hdr_head + size_line(2, 4) + rgbe(1, 1, 1, 3),
        hdr_head + size_line(2, 4) + rgbe(9, 9, 9, 9) + rgbe(1, 1, 1, 9)}) {
    try {
      read_hdr(wrong, "x.hdr");
      ADD_FAILURE() << wrong;
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::bad_data);
      EXPECT_TRUE(error.diagnostics().front().place.element.starts_with("byte ")) << wrong;
    }
  }
}

TEST(Environment, LightOfAnHdrIsExposedForWhitePaper) {
  for (const int exponent : {129, 120, 140}) {
    const LinearImage sky = read_environment(hdr_sky(64, rgbe(128, 128, 128, exponent)), "x.hdr");
    const double even = sky.pixels[64].r;
    if (exponent == 129) {
      EXPECT_NEAR(even, 1, 3e-3) << "all sides alike, up to the rows of the picture";
    } else if (exponent == 140) {
      EXPECT_LT(even, 0.9) << "the lamp takes its share";
    }
  }
}

/// White of 255 is no sun: the same lamp in an .hdr may be as bright as it is.
TEST(Environment, TheSunOfAnHdrThrowsShadows) {
  const EnvironmentLight weak = light_of(read_environment(hdr_sky(64, rgbe(128, 128, 128, 131)), "x.hdr"));
  const EnvironmentLight sun = light_of(read_environment(hdr_sky(64, rgbe(128, 128, 128, 146)), "x.hdr"));
  EXPECT_LT(weak.strength, 0.02);
  EXPECT_GT(sun.strength, 1.5);
  EXPECT_LT(sun.ambient, 0.2);
  EXPECT_LT(sun.softness, 0.1);
}

/// Of 4096 columns squares of 4 are one.
TEST(Environment, LargePicturesLightAsSmallOnes) {
  const auto sky = [](int columns) {
    LinearImage picture{columns, columns / 2, {}};
    for (int i = 0; i < columns * columns / 2; ++i) {
      const int x = i % columns, y = i / columns;
      const bool in_lamp = x >= columns / 8 && x < columns / 4 && y >= columns / 16 && y < columns / 8;
      picture.pixels.emplace_back(in_lamp ? 8.0f : 0.5f);
    }
    return light_of(picture);
  };
  const EnvironmentLight small = sky(512), large = sky(2048);
  EXPECT_NEAR(small.azimuth, large.azimuth, 1e-3);
  EXPECT_NEAR(small.elevation, large.elevation, 1e-3);
  EXPECT_NEAR(small.strength, large.strength, 1e-3);
}

}  // namespace
}  // namespace pomona
