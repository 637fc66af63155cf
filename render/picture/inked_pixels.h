// The pixels that a piece of a stroke covers.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "render/picture/stroke_point.h"

namespace pomona {

/// Calls `found(x, y, hits)` for each pixel of these rows that is covered. Each pixel has 4 x 4 samples; a sample is
/// covered if its distance from the nearest point of the piece from a to b is at most the radius there. Bit s of `hits`
/// is sample s. The result for a pixel does not depend on the choice of rows.
template <typename Found>
void for_inked_pixels(const StrokePoint& a, const StrokePoint& b, int width, PictureRows rows, const Found& found) {
  const double reach = std::max(a.radius, b.radius);
  const double top = std::min(a.at.y, b.at.y) - reach, bottom = std::max(a.at.y, b.at.y) + reach;
  if (bottom < rows.from - 1 || top > rows.to) return;
  const auto pixel = [](double v, int from, int to) {
    return static_cast<int>(std::clamp(std::floor(v), static_cast<double>(from), to - 1.0));
  };
  const int x0 = pixel(std::min(a.at.x, b.at.x) - reach, 0, width);
  const int x1 = pixel(std::max(a.at.x, b.at.x) + reach, 0, width);
  const int y0 = pixel(top, rows.from, rows.to), y1 = pixel(bottom, rows.from, rows.to);
  const glm::dvec2 along = b.at - a.at;
  const double squared = glm::dot(along, along);
  const auto inked = [&](const glm::dvec2& p) {
    const double t = squared > 0 ? std::clamp(glm::dot(p - a.at, along) / squared, 0.0, 1.0) : 0.0;
    const glm::dvec2 away = p - (a.at + along * t);
    const double radius = a.radius + (b.radius - a.radius) * t;
    return glm::dot(away, away) <= radius * radius;
  };
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      std::uint16_t hits = 0;
      for (int s = 0; s < 16; ++s) {
        const glm::dvec2 sample(x + 0.25 * (s % 4) + 0.125, y + 0.25 * (s / 4) + 0.125);
        if (inked(sample)) hits = static_cast<std::uint16_t>(hits | (1u << s));
      }
      if (hits != 0) found(x, y, hits);
    }
  }
}

}  // namespace pomona
