#include "generator/base/color.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace pomona {
namespace {

TEST(Color, every_byte_survives_the_way_to_linear_and_back) {
  for (int i = 0; i < 256; ++i) {
    const glm::u8vec3 srgb(i, 255 - i, (7 * i) % 256);
    EXPECT_EQ(to_srgb8(from_srgb8(srgb)), srgb);
  }
}

TEST(Color, bytes_are_those_of_the_curve_on_either_side_of_every_step) {
  const auto byte_of = [](float linear) {
    return static_cast<int>(std::floor(srgb_from_linear(static_cast<double>(linear)) * 255.0 + 0.5));
  };
  for (int i = 0; i < 255; ++i) {
    const auto step = static_cast<float>(linear_from_srgb((i + 0.5) / 255.0));
    float below = step, above = step;
    for (int k = 0; k < 100; ++k) {
      below = std::nextafter(below, 0.0f), above = std::nextafter(above, 1.0f);
      const glm::u8vec3 found = to_srgb8({below, step, above});
      EXPECT_EQ(glm::ivec3(found), glm::ivec3(byte_of(below), byte_of(step), byte_of(above))) << i;
    }
  }
  EXPECT_EQ(to_srgb8({-1.0f, 2.0f, 1e-40f}), glm::u8vec3(0, 255, 0));
}

TEST(Color, the_transfer_curve_is_that_of_the_standard) {
  EXPECT_EQ(srgb_from_linear(0.0), 0.0);
  EXPECT_NEAR(srgb_from_linear(1.0), 1.0, 1e-15);
  EXPECT_NEAR(linear_from_srgb(0.5), 0.21404114048223255, 1e-15);
  EXPECT_NEAR(srgb_from_linear(0.0031308), 0.0404499, 1e-6);
  EXPECT_EQ(srgb_from_linear(7.0), srgb_from_linear(1.0));
  for (int i = 0; i <= 1000; ++i) EXPECT_NEAR(linear_from_srgb(srgb_from_linear(i / 1000.0)), i / 1000.0, 1e-7);
}

TEST(Color, reads_and_writes_hexadecimal) {
  EXPECT_EQ(*parse_color("#ffffff"), Color(1.0f));
  EXPECT_EQ(to_hex(*parse_color("#c8102e")), "#c8102e");
  EXPECT_EQ(to_hex(*parse_color("#C8102E")), "#c8102e");
  for (const char* text : {"", "#", "c8102e", "#c8102", "#c8102e0", "#12g456", "#-12345", "red"}) {
    EXPECT_FALSE(parse_color(text)) << text;
  }
}

TEST(Color, oklab_knows_white_grey_and_its_way_back) {
  const glm::vec3 white = to_oklab(Color(1.0f));
  EXPECT_NEAR(white.x, 1, 1e-4);
  EXPECT_NEAR(white.y, 0, 1e-4);
  EXPECT_NEAR(white.z, 0, 1e-4);
  EXPECT_NEAR(to_oklab(Color(0.125f)).x, 0.5, 1e-4);  // lightness is the cube root of a gray
  for (int i = 0; i < 64; ++i) {
    const Color color(static_cast<float>(i % 4) / 3, static_cast<float>(i / 4 % 4) / 3, static_cast<float>(i / 16) / 3);
    EXPECT_LT(glm::distance(from_oklab(to_oklab(color)), color), 1e-5f);
  }
}

}  // namespace
}  // namespace pomona
