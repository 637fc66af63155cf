// Which samples of a grid a triangle covers, exactly: in fixed point.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <glm/vec3.hpp>

#include "render/image/triangle_raster.h"
#include "render/thumbnail/projection.h"

namespace pomona {

/// Calls visit(x, y, weights) for each sample of a square grid whose middle the triangle covers, edges included; row by
/// row. Weights are barycentric. The orientation of the triangle does not matter.
template <typename Visit>
void for_covered_samples(const std::array<ProjectedPoint, 3>& corners, int side, const Visit& visit) {
  // Corners on a grid of 1/16 sample, clamped far outside of the picture so that products fit.
  constexpr std::int64_t steps = 16;
  const auto snapped = [](double v) { return std::llround(std::clamp(v, -1e6, 1e6) * steps); };
  const auto point = [&](const ProjectedPoint& p) { return glm::i64vec2(snapped(p.x), snapped(p.y)); };
  const TriangleRaster<std::int64_t> raster(point(corners[0]), point(corners[1]), point(corners[2]));
  if (raster.area() == 0) return;
  const double share = 1 / static_cast<double>(raster.area());
  raster.for_covered({steps / 2, steps, {0, 0, side - 1, side - 1}},
                     [&](int x, int y, const glm::i64vec3& shares) { visit(x, y, glm::dvec3(shares) * share); });
}

}  // namespace pomona
