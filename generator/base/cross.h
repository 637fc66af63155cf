// The cross product in the plane.
#pragma once

#include <glm/vec2.hpp>

namespace pomona {

/// Twice the area of the triangle that two directions span: positive where b lies counter-clockwise of a, y up.
inline double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

}  // namespace pomona
