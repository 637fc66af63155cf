// Convex hulls that a game can collide with.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace pomona {

struct ConvexHull {
  std::vector<glm::vec3> position;
  std::vector<glm::uvec3> triangle;  ///< counter-clockwise seen from outside
};

/// The hull of the points, or, where that has more vertices than `most`, of those of them that stand out farthest
/// [Barber, Dobkin and Huhdanpaa 1996, stopped early]: it lies within the whole hull. Empty for points in a plane. The
/// same for the same points, on every machine.
/// \param most vertices, at least 14.
ConvexHull convex_hull(std::span<const glm::vec3> points, std::size_t most = 64);

}  // namespace pomona
