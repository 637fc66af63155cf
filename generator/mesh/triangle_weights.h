// Where in a triangle a point lies.
#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace pomona {

/// The barycentric coordinates of a point in a triangle: none below 0, and 1 in sum. (1, 0, 0) in one without an area.
std::array<double, 3> weights_in(const std::array<glm::dvec3, 3>& corner, const glm::dvec3& point);

}  // namespace pomona
