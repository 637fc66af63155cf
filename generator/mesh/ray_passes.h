// Whether a line along an axis passes through a triangle.
#pragma once

#include <cstddef>
#include <utility>

#include "generator/mesh/triangle_distance.h"

namespace pomona {

/// True if the line through `point` along the axis `along` passes through the triangle, seen on the plane of the other
/// two axes. The answers of triangles that share an edge agree on it, so closed meshes have no leaks.
inline bool ray_passes(const TriangleCorners& t, const glm::dvec3& point, int along) {
  const int u = (along + 1) % 3, v = (along + 2) % 3;
  bool inside = false;
  for (std::size_t i = 0; i < 3; ++i) {
    glm::dvec3 a = t[i], b = t[(i + 1) % 3];
    if ((a[u] > point[u]) == (b[u] > point[u])) continue;
    if (a[u] > b[u]) std::swap(a, b);
    if (a[v] + (b[v] - a[v]) * ((point[u] - a[u]) / (b[u] - a[u])) > point[v]) inside = !inside;
  }
  return inside;
}

}  // namespace pomona
