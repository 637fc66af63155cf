// The convex hull of points in space.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace pomona {

struct ConvexHull {
  std::vector<glm::dvec3> point;     ///< the corners
  std::vector<glm::uvec3> triangle;  ///< counter-clockwise seen from outside; none if the points are flat
};

double volume(const ConvexHull& hull);

/// The hull by exact arithmetic on coordinates rounded to 1e-4 of the extent [Bullet's hull computer]; corners
/// are the given points, unrounded.
ConvexHull convex_hull(std::span<const glm::dvec3> points);

/// The corners of the hull with every face moved inwards by `by`, or half as deep as the hull is thick, if
/// that is less. Flat hulls come back as they are.
std::vector<glm::dvec3> shrunken_corners(std::span<const glm::dvec3> points, double by);

}  // namespace pomona
