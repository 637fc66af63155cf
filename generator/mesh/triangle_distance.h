// Distances between points, segments and triangles [Ericson 2005, Real-Time Collision Detection, 5.1].
#pragma once

#include <array>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace pomona {

using TriangleCorners = std::array<glm::dvec3, 3>;

/// The nearest point of a triangle, which may be a line or a point. Rounded otherwise than nearest_weights().
glm::dvec3 nearest_on_triangle(const glm::dvec3& point, const TriangleCorners& triangle);

/// The place of a triangle with an area that is nearest to p, as weights of its corners.
template <typename T>
glm::vec<3, T> nearest_weights(const glm::vec<3, T>& p, const glm::vec<3, T>& a, const glm::vec<3, T>& b,
                               const glm::vec<3, T>& c);

/// The nearest points of two segments p0-p1 and q0-q1.
std::array<glm::dvec3, 2> nearest_on_segments(const glm::dvec3& p0, const glm::dvec3& p1, const glm::dvec3& q0,
                                              const glm::dvec3& q1);

/// The nearest points of two triangles: equal where they cross.
std::array<glm::dvec3, 2> nearest_on_triangles(const TriangleCorners& a, const TriangleCorners& b);

template <typename T>
glm::vec<3, T> nearest_weights(const glm::vec<3, T>& p, const glm::vec<3, T>& a, const glm::vec<3, T>& b,
                               const glm::vec<3, T>& c) {
  const glm::vec<3, T> ab = b - a, ac = c - a;

  // At a, at b, or on the edge between them.
  const T d1 = glm::dot(ab, p - a), d2 = glm::dot(ac, p - a);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const T d3 = glm::dot(ab, p - b), d4 = glm::dot(ac, p - b);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const T on_c = d1 * d4 - d3 * d2;
  if (on_c <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};

  // At c, or on the edges that meet there.
  const T d5 = glm::dot(ab, p - c), d6 = glm::dot(ac, p - c);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const T on_b = d5 * d2 - d1 * d6;
  if (on_b <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  const T on_a = d3 * d6 - d5 * d4;
  if (on_a <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const T w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - w, w};
  }

  // Inside.
  const T sum = on_a + on_b + on_c;
  return {1 - on_b / sum - on_c / sum, on_b / sum, on_c / sum};
}

}  // namespace pomona
