#include "generator/base/color.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>

#include "generator/base/reproducible.h"

namespace pomona {

double srgb_from_linear(double linear) {
  linear = std::clamp(linear, 0.0, 1.0);
  if (linear <= 0.0031308) return 12.92 * linear;
  return 1.055 * reproducible::pow(linear, 1.0 / 2.4) - 0.055;
}

double linear_from_srgb(double srgb) {
  srgb = std::clamp(srgb, 0.0, 1.0);
  if (srgb <= 0.04045) return srgb / 12.92;
  return reproducible::pow((srgb + 0.055) / 1.055, 2.4);
}

namespace {

std::uint8_t to_byte(double value) { return static_cast<std::uint8_t>(std::floor(value * 255.0 + 0.5)); }

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

glm::u8vec3 to_srgb8(const Color& color) {
  return {to_byte(srgb_from_linear(color.r)), to_byte(srgb_from_linear(color.g)), to_byte(srgb_from_linear(color.b))};
}

Color from_srgb8(const glm::u8vec3& srgb) {
  return {static_cast<float>(linear_from_srgb(srgb.r / 255.0)), static_cast<float>(linear_from_srgb(srgb.g / 255.0)),
          static_cast<float>(linear_from_srgb(srgb.b / 255.0))};
}

std::optional<Color> parse_color(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  std::array<std::uint8_t, 3> channel{};
  for (std::size_t i = 0; i < 3; ++i) {
    const int high = hex_digit(text[1 + 2 * i]);
    const int low = hex_digit(text[2 + 2 * i]);
    if (high < 0 || low < 0) return std::nullopt;
    channel[i] = static_cast<std::uint8_t>(16 * high + low);
  }
  return from_srgb8({channel[0], channel[1], channel[2]});
}

std::string to_hex(const Color& color) {
  constexpr char digits[] = "0123456789abcdef";
  const glm::u8vec3 srgb = to_srgb8(color);
  std::string text = "#";
  for (int i = 0; i < 3; ++i) {
    text += digits[srgb[i] >> 4];
    text += digits[srgb[i] & 15];
  }
  return text;
}

glm::vec3 to_oklab(const Color& color) {
  const double r = color.r, g = color.g, b = color.b;
  const double l = reproducible::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = reproducible::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = reproducible::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return {static_cast<float>(0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s),
          static_cast<float>(1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s),
          static_cast<float>(0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s)};
}

Color from_oklab(const glm::vec3& lab) {
  const double l = lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z;
  const double m = lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z;
  const double s = lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z;
  const double l3 = l * l * l, m3 = m * m * m, s3 = s * s * s;
  return {static_cast<float>(4.0767416621 * l3 - 3.3077115913 * m3 + 0.2309699292 * s3),
          static_cast<float>(-1.2684380046 * l3 + 2.6097574011 * m3 - 0.3413193965 * s3),
          static_cast<float>(-0.0041960863 * l3 - 0.7034186147 * m3 + 1.7076147010 * s3)};
}

Color from_oklab_within_gamut(const glm::vec3& lab) { return glm::clamp(from_oklab(lab), Color(0.0f), Color(1.0f)); }

}  // namespace pomona
