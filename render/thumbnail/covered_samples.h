// Which samples of a grid a triangle covers, exactly: integer edge tests.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/thumbnail/projection.h"

namespace pomona {

/// Calls visit(x, y, weights) for each sample of a square grid whose middle the triangle covers, edges included; row by
/// row. Weights are the corners' shares there, with the sum of one. Which way the triangle turns does not matter.
template <typename Visit>
void for_covered_samples(const std::array<ProjectedPoint, 3>& corners, int side, Visit&& visit) {
  // Corners on a grid of 1/16 sample; far off the picture they stay where products still fit.
  constexpr std::int64_t steps = 16;
  const double far = 1e6;
  std::array<glm::i64vec2, 3> p;
  for (int k = 0; k < 3; ++k) {
    p[k] = {std::llround(std::clamp(corners[k].x, -far, far) * steps),
            std::llround(std::clamp(corners[k].y, -far, far) * steps)};
  }
  const auto cross = [](const glm::i64vec2& a, const glm::i64vec2& b) { return a.x * b.y - a.y * b.x; };
  const std::int64_t area = cross(p[1] - p[0], p[2] - p[0]);
  if (area == 0) return;
  const std::int64_t sign = area > 0 ? 1 : -1;
  const double share = 1 / static_cast<double>(area * sign);

  // The rows and columns whose middles may be covered.
  const auto first = [](std::int64_t low) { return std::max<std::int64_t>(0, (low - steps / 2 + steps - 1) / steps); };
  const auto last = [side](std::int64_t high) { return std::min<std::int64_t>(side - 1, (high - steps / 2) / steps); };
  const glm::i64vec2 low = glm::min(glm::min(p[0], p[1]), p[2]), high = glm::max(glm::max(p[0], p[1]), p[2]);
  if (high.x < 0 || high.y < 0) return;
  const std::int64_t begin = first(low.x), end = last(high.x);

  // What each edge says of a sample grows evenly along a row.
  for (std::int64_t y = first(low.y); y <= last(high.y); ++y) {
    const glm::i64vec2 middle(begin * steps + steps / 2, y * steps + steps / 2);
    std::array<std::int64_t, 3> inside, step;
    for (int k = 0; k < 3; ++k) {
      const glm::i64vec2 &a = p[(k + 1) % 3], &b = p[(k + 2) % 3];
      inside[k] = sign * cross(b - a, middle - a);
      step[k] = -sign * (b - a).y * steps;
    }
    for (std::int64_t x = begin; x <= end; ++x) {
      if ((inside[0] | inside[1] | inside[2]) >= 0)
        visit(
            static_cast<int>(x), static_cast<int>(y),
            glm::dvec3(static_cast<double>(inside[0]), static_cast<double>(inside[1]), static_cast<double>(inside[2])) *
                share);
      for (int k = 0; k < 3; ++k) inside[k] += step[k];
    }
  }
}

}  // namespace pomona
