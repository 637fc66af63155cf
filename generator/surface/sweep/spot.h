// One spot on a surface: its position and what it covers.
#pragma once

#include <array>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/base/color.h"

namespace pomona {

/// A spot at its position.
struct Spot {
  glm::dvec3 center{0};
  glm::dvec3 normal{0, 1, 0};   ///< unit, of the front, whichever side it is on
  glm::dvec3 tangent{1, 0, 0};  ///< unit, along the vertical curve
  double radius = 0;            ///< metres, across the curve
  double stretch = 1, softness = 0, strength = 1;
  std::array<glm::dvec2, 4> waves{};  ///< waves of the outline, 2 to 5 around it; their lengths add up to the
                                      ///< raggedness
  Color color{0};
  double relief = 0;  ///< height above the surface, metres, negative = below; only for shading, no vertex moves
};

/// The share of a spot at a point of the surface, 0..1; `normal` is the front's there, unit.
/// The distance is that of the chord, longer where the surface turns away from the spot: chord / ((1 + cos turned) /
/// 2)^(1/4). On a sphere this is within 7 % of the distance along the surface, up to a right angle; and a spot never
/// shows through a thin wall.
double cover_of(const Spot& spot, const glm::dvec3& point, const glm::dvec3& normal);

/// The spot covers no point farther from its middle than this, metres.
double reach_of(const Spot& spot);

}  // namespace pomona
