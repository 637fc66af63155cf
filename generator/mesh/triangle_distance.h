// Distances between points, segments and triangles [Ericson 2005, Real-Time Collision Detection, 5.1].
#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace pomona {

using TriangleCorners = std::array<glm::dvec3, 3>;

glm::dvec3 nearest_on_triangle(const glm::dvec3& point, const TriangleCorners& triangle);

/// The nearest points of two segments p0-p1 and q0-q1.
std::array<glm::dvec3, 2> nearest_on_segments(const glm::dvec3& p0, const glm::dvec3& p1, const glm::dvec3& q0,
                                              const glm::dvec3& q1);

/// The nearest points of two triangles: equal where they cross.
std::array<glm::dvec3, 2> nearest_on_triangles(const TriangleCorners& a, const TriangleCorners& b);

}  // namespace pomona
