#include "render/marks/flow_field.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "generator/base/color.h"
#include "render/marks/blur.h"

namespace pomona {

namespace {

constexpr int max_side = 1600;  // pixels; flow is smooth, so larger prints need no finer one

/// The means of squares of pixels; squares at the right and the lower edge may be smaller.
Image in_squares(const Image& image, int square) {
  if (square == 1) return image;
  Image small{(image.width + square - 1) / square, (image.height + square - 1) / square, {}};
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      glm::ivec3 sum(0);
      int count = 0;
      for (int v = y * square; v < std::min((y + 1) * square, image.height); ++v) {
        for (int u = x * square; u < std::min((x + 1) * square, image.width); ++u, ++count) {
          sum += glm::ivec3(image.at(u, v));
        }
      }
      small.pixels.emplace_back(sum / count);
    }
  }
  return small;
}

/// The symmetric tensor (xx xy; xy yy) of each pixel.
struct Tensors {
  std::vector<float> xx, xy, yy;
};

/// The outer products of the gradients of lightness and both chromas, summed, by Sobel's differences.
Tensors edges_of(const Image& painted) {
  const int width = painted.width, height = painted.height;
  std::vector<glm::vec3> lab(painted.pixels.size());
  for (std::size_t i = 0; i < lab.size(); ++i) lab[i] = to_oklab(from_srgb8(painted.pixels[i]));
  const auto at = [&](int x, int y) {
    return lab[static_cast<std::size_t>(std::clamp(y, 0, height - 1)) * width + std::clamp(x, 0, width - 1)];
  };

  Tensors edges{std::vector<float>(lab.size()), std::vector<float>(lab.size()), std::vector<float>(lab.size())};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::vec3 right = at(x + 1, y - 1) + 2.0f * at(x + 1, y) + at(x + 1, y + 1);
      const glm::vec3 left = at(x - 1, y - 1) + 2.0f * at(x - 1, y) + at(x - 1, y + 1);
      const glm::vec3 below = at(x - 1, y + 1) + 2.0f * at(x, y + 1) + at(x + 1, y + 1);
      const glm::vec3 above = at(x - 1, y - 1) + 2.0f * at(x, y - 1) + at(x + 1, y - 1);
      const glm::vec3 dx = right - left, dy = below - above;
      const std::size_t i = static_cast<std::size_t>(y) * width + x;
      edges.xx[i] = glm::dot(dx, dx);
      edges.xy[i] = glm::dot(dx, dy);
      edges.yy[i] = glm::dot(dy, dy);
    }
  }
  return edges;
}

/// The unit vector at half the angle of the unit vector (c, s).
glm::vec2 at_half_angle(double c, double s) {
  const double x = std::sqrt(std::max(0.0, (1 + c) / 2)), y = std::sqrt(std::max(0.0, (1 - c) / 2));
  return {static_cast<float>(x), static_cast<float>(s < 0 ? -y : y)};
}

/// Perpendicular to (xx - yy, 2 xy) at half the angle: the minor direction of the tensor.
glm::vec2 minor_direction(double xx, double xy, double yy) {
  const double c = yy - xx, s = -2 * xy, size = std::sqrt(c * c + s * s);
  return size > 0 ? at_half_angle(c / size, s / size) : glm::vec2(1, 0);
}

}  // namespace

glm::dvec2 FlowField::at(const glm::dvec2& place, const glm::dvec2& heading) const {
  const int x = std::clamp(static_cast<int>(std::floor(place.x / square)), 0, width - 1);
  const int y = std::clamp(static_cast<int>(std::floor(place.y / square)), 0, height - 1);
  const glm::dvec2 way(direction[static_cast<std::size_t>(y) * width + x]);
  return glm::dot(way, heading) < 0 ? -way : way;
}

FlowField flow_of(const Image& whole, const FlowOptions& options) {
  const int square = std::max(1, (std::max(whole.width, whole.height) + max_side - 1) / max_side);
  const Image painted = in_squares(whole, square);

  // The same edges gathered over three widths.
  Tensors sum{std::vector<float>(painted.pixels.size()), std::vector<float>(painted.pixels.size()),
              std::vector<float>(painted.pixels.size())};
  struct Gathering {
    double times, weight;
  };
  constexpr std::array gatherings{Gathering{1, 1}, Gathering{3, 0.15}, Gathering{9, 0.02}};
  const Tensors edges = edges_of(painted);
  for (const Gathering& gathering : gatherings) {
    const auto add = [&](std::vector<float>& to, const std::vector<float>& from) {
      const std::vector<float> wide =
          blurred(from, painted.width, painted.height, gathering.times * options.scale / square);
      for (std::size_t i = 0; i < to.size(); ++i) to[i] += static_cast<float>(gathering.weight) * wide[i];
    };
    add(sum.xx, edges.xx);
    add(sum.xy, edges.xy);
    add(sum.yy, edges.yy);
  }

  // Adds a little of the default direction, so that every place has one.
  const double faint = 1e-5;
  const glm::dvec2 across(-options.otherwise.y, options.otherwise.x);
  FlowField field{painted.width, painted.height, std::vector<glm::vec2>(painted.pixels.size()), square};
  for (std::size_t i = 0; i < field.direction.size(); ++i) {
    field.direction[i] =
        minor_direction(sum.xx[i] + faint * across.x * across.x, sum.xy[i] + faint * across.x * across.y,
                        sum.yy[i] + faint * across.y * across.y);
  }
  return field;
}

}  // namespace pomona
