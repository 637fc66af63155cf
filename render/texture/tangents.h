// Tangents of a textured mesh, for normal maps.
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace pomona {

/// Per vertex: the unit direction in which u grows, perpendicular to the normal; and 1, because textures are laid as
/// seen from the air, so that v runs against normal x tangent. The direction is the mean of the triangles around,
/// weighted by area; any direction where there is none, as in specks.
std::vector<glm::vec4> tangents(std::span<const glm::vec3> position, std::span<const glm::vec3> normal,
                                std::span<const glm::vec2> uv, std::span<const glm::uvec3> triangle);

}  // namespace pomona
