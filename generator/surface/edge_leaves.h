// Triangles around an edge that more than two share, in the order in which one meets them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/mesh/edges.h"

namespace pomona {

/// A triangle at an edge of more than two: its angle around the edge, seen against the edge's direction.
struct EdgeLeaf {
  double angle = 0;      ///< -pi to pi, from the first triangle of the edge
  bool forward = false;  ///< solid lies below its angle; else above
  std::uint32_t triangle = 0;
};

/// True if the two lie at one angle, to 1e-6 radians.
bool at_one_angle(const EdgeLeaf& a, const EdgeLeaf& b);

/// By angle. Of leaves at one angle those come first where solid ends: solids that touch face to face end before the
/// next one starts.
/// \param triangles welded, facing air
std::vector<EdgeLeaf> leaves_around(std::span<const HalfEdge> edge, std::span<const glm::uvec3> triangles,
                                    std::span<const glm::vec3> position);

}  // namespace pomona
