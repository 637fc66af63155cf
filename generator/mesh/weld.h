// Vertices at equal positions made one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace pomona {

/// For each vertex the smallest index among the vertices at the very same position (-0 equals 0).
std::vector<std::uint32_t> weld(std::span<const glm::vec3> positions);
std::vector<std::uint32_t> weld(std::span<const glm::dvec3> positions);

/// The same triangles between vertices after welding, given by weld().
std::vector<glm::uvec3> welded_triangles(std::span<const std::uint32_t> first, std::span<const glm::uvec3> triangles);

}  // namespace pomona
