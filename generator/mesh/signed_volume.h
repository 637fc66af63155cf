// The volume that triangles bound.
#pragma once

#include <array>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace pomona {

/// Six times the volume of the tetrahedron between a triangle and the origin, cubic metres; above 0 where the triangle
/// runs counter-clockwise as seen from the side away from the origin.
inline double six_volumes(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return glm::dot(a, glm::cross(b, c));
}

/// The volume that closed triangles bound, cubic metres; below 0 where they face inwards.
/// \param corners_of gives the three corners of one of the triangles; an origin among them rounds least
template <typename Triangles, typename CornersOf>
double signed_volume(const Triangles& triangles, const CornersOf& corners_of) {
  double six = 0;
  for (const auto& triangle : triangles) {
    const std::array<glm::dvec3, 3> corner = corners_of(triangle);
    six += six_volumes(corner[0], corner[1], corner[2]);
  }
  return six / 6;
}

}  // namespace pomona
