#include "render/image/backdrop.h"

#include <algorithm>
#include <cmath>

#include "generator/base/color.h"
#include "render/image/linear_pixels.h"

namespace pomona {

namespace {

/// How bright the white paper is at each pixel that shows some of it. At the rim of things, where a pixel shows both,
/// it is as bright as the paper beside it.
std::vector<Color> paper_light(const std::vector<Color>& pixels, const CoveredShares& covered, int width, int height) {
  std::vector<Color> light(pixels.size(), Color(1));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * width + x;
      if (covered[i] <= 0) light[i] = pixels[i];
      if (covered[i] <= 0 || covered[i] >= 1) continue;
      Color sum(0);
      int count = 0;
      for (int row = std::max(0, y - 1); row <= std::min(height - 1, y + 1); ++row) {
        for (int column = std::max(0, x - 1); column <= std::min(width - 1, x + 1); ++column) {
          const std::size_t beside = static_cast<std::size_t>(row) * width + column;
          if (covered[beside] > 0) continue;
          sum += pixels[beside];
          ++count;
        }
      }
      if (count > 0) light[i] = sum / static_cast<float>(count);
    }
  }
  return light;
}

}  // namespace

Image before(const Image& on_white, const CoveredShares& covered, const Image& backdrop) {
  std::vector<Color> pixels = linear_pixels(on_white);
  const std::vector<Color> behind = linear_pixels(backdrop);
  const std::vector<Color> light = paper_light(pixels, covered, on_white.width, on_white.height);
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] += (1 - covered[i]) * light[i] * (behind[i] - 1.0f);
  return image_of(pixels, on_white.width, on_white.height);
}

TransparentImage before_nothing(const Image& on_white, const CoveredShares& covered) {
  std::vector<Color> pixels = linear_pixels(on_white);
  const std::vector<Color> light = paper_light(pixels, covered, on_white.width, on_white.height);
  TransparentImage result;
  result.opacity.reserve(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const float seen_through = 1 - covered[i];
    const float brightest = std::clamp(std::max({light[i].x, light[i].y, light[i].z}), 0.0f, 1.0f);
    const float opacity = 1 - seen_through * brightest;
    pixels[i] = opacity > 0 ? (pixels[i] - seen_through * light[i]) / opacity : Color(0);
    result.opacity.push_back(static_cast<std::uint8_t>(std::lround(255 * opacity)));
  }
  result.image = image_of(pixels, on_white.width, on_white.height);
  return result;
}

Image cropped(const Image& whole, int width, int height, const glm::dvec2& at, double share) {
  const double scale =
      share * std::min(static_cast<double>(whole.width) / width, static_cast<double>(whole.height) / height);
  const glm::dvec2 corner = at * (glm::dvec2(whole.width, whole.height) - scale * glm::dvec2(width, height));
  Image part{width, height, {}};
  part.pixels.reserve(static_cast<std::size_t>(width) * height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      // Between the middles of four pixels.
      const double u = std::clamp(corner.x + scale * (x + 0.5) - 0.5, 0.0, whole.width - 1.0);
      const double v = std::clamp(corner.y + scale * (y + 0.5) - 0.5, 0.0, whole.height - 1.0);
      const int left = static_cast<int>(u), top = static_cast<int>(v);
      const int right = std::min(left + 1, whole.width - 1), bottom = std::min(top + 1, whole.height - 1);
      const double s = u - left, t = v - top;
      const glm::dvec3 upper = glm::dvec3(whole.at(left, top)) * (1 - s) + glm::dvec3(whole.at(right, top)) * s;
      const glm::dvec3 lower = glm::dvec3(whole.at(left, bottom)) * (1 - s) + glm::dvec3(whole.at(right, bottom)) * s;
      part.pixels.emplace_back(upper * (1 - t) + lower * t + 0.5);
    }
  }
  return part;
}

}  // namespace pomona
