// Charts: a solid's surface laid flat in parts, for texturing.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/scene/solid.h"

namespace pomona {

/// Connected triangles that are projected along one direction without folding over: a cut face along its
/// normal, skin along the coordinate axis it faces most.
struct Chart {
  std::vector<std::uint32_t> triangles;
  glm::dvec3 u{1, 0, 0}, v{0, 1, 0};  ///< the plane's axes
  glm::dvec2 low{0}, high{0};         ///< bounds in the plane, metres
  std::int32_t cut_face = -1;

  glm::dvec2 project(const glm::vec3& p) const {
    const glm::dvec3 q(p);
    return {u.x * q.x + u.y * q.y + u.z * q.z, v.x * q.x + v.y * q.y + v.z * q.z};
  }
};

/// Every triangle is in exactly one chart.
std::vector<Chart> charts_of(const Solid& solid);

/// Where each chart's lower corner lies in a square of `side` texels, at the largest scale that fits.
struct Packing {
  double texels_per_metre = 0;
  std::vector<glm::ivec2> corner;  ///< of the chart's margin, texels
};

/// Shelves, tallest charts first, `margin` texels around each. \throws Error (usage) if even the smallest
/// scale does not fit.
Packing packed(const std::vector<Chart>& charts, int side, int margin);

}  // namespace pomona
