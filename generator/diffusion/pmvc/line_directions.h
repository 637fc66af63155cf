// Directions for draft and final: the same for all points, in opposite pairs.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace pomona {

/// A line through every point, seen both ways: along +along and along -along, equal solid angles. across_u,
/// across_v, along are orthonormal and right-handed.
struct Line {
  glm::vec3 across_u{0}, across_v{0}, along{0};
};

/// The line along a unit vector, in some frame [Duff et al. 2017].
Line line_along(const glm::dvec3& along);

/// `count` lines spread evenly over all orientations: half of a Fibonacci spiral [Swinbank & Purser 2006],
/// whose mirror image is the other half, turned so that its pole is no axis of a fruit. Opposite pairs make
/// the sum of all directions zero, and with it positive mean values exact on linear fields in closed scenes.
std::vector<Line> line_directions(int count);

}  // namespace pomona
