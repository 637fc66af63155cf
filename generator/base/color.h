// Colours. Inside Pomona a colour is linear RGB with the primaries of sRGB. The sRGB curve is used only where files and
// pictures are read or written.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

namespace pomona {

/// Linear RGB, nominally 0..1 a channel.
using Color = glm::vec3;

/// sRGB transfer curve (IEC 61966-2-1), one channel, 0..1 to 0..1, the same bits on every processor.
double srgb_from_linear(double linear);
double linear_from_srgb(double srgb);

/// Eight-bit sRGB, as pictures and PLY viewers want it; clamped, rounded to nearest.
glm::u8vec3 to_srgb8(const Color& color);
Color from_srgb8(const glm::u8vec3& srgb);

/// Reads "#rrggbb"; nothing if it is not one.
std::optional<Color> parse_color(std::string_view text);
std::string to_hex(const Color& color);

/// Linear light, `share` 0..1 of the second; exact at both ends.
inline Color blended(const Color& first, const Color& second, double share) {
  const auto s = static_cast<float>(share);
  return first * (1 - s) + second * s;
}

/// Perceptual OKLab (Ottosson 2020) of a linear colour, and back; used by noise and styles.
glm::vec3 to_oklab(const Color& color);
Color from_oklab(const glm::vec3& lab);

/// The same with every channel kept within 0..1.
Color from_oklab_within_gamut(const glm::vec3& lab);

}  // namespace pomona
