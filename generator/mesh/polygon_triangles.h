// Polygons cut into triangles, concave ones too.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace pomona {

/// Triangles that fill a polygon and turn as it does, as numbers of its corners: a fan around the first corner where
/// that stays within the polygon, else a constrained Delaunay triangulation of it as seen along its normal. A bridge
/// that leads to a hole and back is none of its border. A polygon without area becomes a fan; one that crosses itself,
/// nothing.
std::optional<std::vector<glm::uvec3>> polygon_triangles(std::span<const glm::dvec3> corners);

}  // namespace pomona
