#include "generator/base/color.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include <glm/common.hpp>

#include "generator/base/many_values.h"
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

/// The bytes of linear values, looked up: what to_byte(srgb_from_linear(value)) gives, for every float.
class Encoder {
 public:
  Encoder() {
    // The least float of each byte, by halving what lies between the bits of 0 and of 1.
    for (std::size_t byte = 1; byte < min_.size(); ++byte) {
      std::uint32_t below = std::bit_cast<std::uint32_t>(min_[byte - 1]), at = std::bit_cast<std::uint32_t>(1.0f);
      while (at - below > 1) {
        const std::uint32_t middle = below + (at - below) / 2;
        const double encoded = srgb_from_linear(static_cast<double>(std::bit_cast<float>(middle)));
        (to_byte(encoded) < byte ? below : at) = middle;
      }
      min_[byte] = std::bit_cast<float>(at);
    }

    // The start of the search: the byte of the smallest value of each cell.
    std::uint8_t byte = 0;
    for (std::size_t cell = 0; cell < start_.size(); ++cell) {
      const float value = std::bit_cast<float>(static_cast<std::uint32_t>(cell + first_cell) << cell_shift);
      while (byte < 255 && value >= min_[byte + 1U]) ++byte;
      start_[cell] = byte;
    }
  }

  std::uint8_t operator()(float linear) const {
    if (!(linear >= min_[1])) return 0;
    if (linear >= min_[255]) return 255;
    std::uint8_t byte = start_[(std::bit_cast<std::uint32_t>(linear) >> cell_shift) - first_cell];
    while (linear >= min_[byte + 1U]) ++byte;
    return byte;
  }

 private:
  // Cells are what floats share in their exponent and the first seven bits after it, from 2^-13, which is black, to 1.
  static constexpr std::uint32_t cell_shift = 16, first_cell = (127 - 13) << 7, cells = 13 << 7;
  std::array<float, 256> min_{};
  std::array<std::uint8_t, cells> start_{};
};

/// What the cones of the eye make of a linear colour.
glm::dvec3 cones_of(const Color& color) {
  const double r = color.r, g = color.g, b = color.b;
  return {0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b,
          0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b,
          0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b};
}

/// OKLab, of the cones' cube roots.
glm::vec3 lab_of(double l, double m, double s) {
  return {static_cast<float>(0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s),
          static_cast<float>(1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s),
          static_cast<float>(0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s)};
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

glm::u8vec3 to_srgb8(const Color& color) {
  static const Encoder encoder;
  return {encoder(color.r), encoder(color.g), encoder(color.b)};
}

Color from_srgb8(const glm::u8vec3& srgb) {
  static const std::array<float, 256> decoded = [] {
    std::array<float, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i)
      table[i] = static_cast<float>(linear_from_srgb(static_cast<double>(i) / 255.0));
    return table;
  }();
  return {decoded[srgb.r], decoded[srgb.g], decoded[srgb.b]};
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
  const glm::dvec3 cones = cones_of(color);
  const auto [l, m, s, unused] = reproducible::cbrt({cones.x, cones.y, cones.z, 1.0});
  return lab_of(l, m, s);
}

std::vector<glm::vec3> to_oklab(std::span<const glm::vec3> colors) {
  std::vector<double> cones(3 * colors.size());
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const glm::dvec3 own = cones_of(colors[i]);
    cones[3 * i] = own.x, cones[3 * i + 1] = own.y, cones[3 * i + 2] = own.z;
  }
  const std::vector<double> root = reproducible::cube_roots(cones);
  std::vector<glm::vec3> lab(colors.size());
  for (std::size_t i = 0; i < lab.size(); ++i) lab[i] = lab_of(root[3 * i], root[3 * i + 1], root[3 * i + 2]);
  return lab;
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
