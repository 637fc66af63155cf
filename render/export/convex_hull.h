// Convex hulls, for collisions in games.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace pomona {

struct ConvexHull {
  std::vector<glm::vec3> position;
  std::vector<glm::uvec3> triangle;  ///< counter-clockwise seen from outside
};

/// The hull of the points. If it has more than `max` vertices, the hull of those that stand out farthest [Barber,
/// Dobkin and Huhdanpaa 1996, stopped early], which lies inside the whole hull. Empty for points in a plane. The result
/// is the same on every machine. \param max largest number of vertices, at least 14.
ConvexHull convex_hull(std::span<const glm::vec3> points, std::size_t max = 64);

}  // namespace pomona
