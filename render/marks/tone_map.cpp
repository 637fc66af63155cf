#include "render/marks/tone_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "render/marks/blur.h"

namespace pomona {

namespace {

constexpr int levels = 1024;

/// The darkness that `share` of all pixels darker than `bare` do not exceed; 1 if there are none.
double quantile(const std::vector<float>& darkness, double bare, double share) {
  std::array<std::uint64_t, levels> count{};
  std::uint64_t all = 0;
  for (const float dark : darkness) {
    if (dark <= bare) continue;
    ++count[static_cast<std::size_t>(std::clamp(static_cast<int>(dark * levels), 0, levels - 1))];
    ++all;
  }
  std::uint64_t below = 0;
  for (int level = 0; level < levels && all > 0; ++level) {
    below += count[static_cast<std::size_t>(level)];
    if (static_cast<double>(below) >= share * static_cast<double>(all)) return (level + 1.0) / levels;
  }
  return 1;
}

}  // namespace

double ToneMap::at(const glm::dvec2& place) const {
  const int x = static_cast<int>(std::floor(place.x)), y = static_cast<int>(std::floor(place.y));
  if (x < 0 || y < 0 || x >= width || y >= height) return 0;
  return darkness[static_cast<std::size_t>(y) * width + x];
}

ToneMap tones_of(const Image& painted, const Color& paper, const ToneOptions& options) {
  // The difference of lightness between the paper and the pixel.
  ToneMap map{painted.width, painted.height, std::vector<float>(painted.pixels.size())};
  const double light = std::max<double>(to_oklab(paper).x, 0.05);
  for (std::size_t i = 0; i < map.darkness.size(); ++i) {
    const double lightness = to_oklab(from_srgb8(painted.pixels[i])).x;
    map.darkness[i] = static_cast<float>(std::clamp((light - lightness) / light, 0.0, 1.0));
  }
  map.darkness = blurred(std::move(map.darkness), map.width, map.height, options.blur);

  if (!options.stretched) return map;

  // Stretches from bare paper to the picture's darkest.
  const double max = std::max(quantile(map.darkness, options.bare, options.darkest), 2 * options.bare);
  for (float& dark : map.darkness) {
    dark = static_cast<float>(std::clamp((dark - options.bare) / (max - options.bare), 0.0, 1.0));
  }
  return map;
}

}  // namespace pomona
