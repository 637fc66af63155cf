// Edges found after welding equal positions: the half-edge work behind shells, rims and normals. A sorted list
// instead of a half-edge structure, because imported surfaces may branch, cross and repeat themselves, which a
// half-edge structure refuses.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace pomona {

/// For each vertex the smallest index among the vertices at the very same position (-0 equals 0).
std::vector<std::uint32_t> weld(std::span<const glm::vec3> positions);
std::vector<std::uint32_t> weld(std::span<const glm::dvec3> positions);

/// Vertices after welding, for triangle corners.
std::vector<glm::uvec3> welded_triangles(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles);

/// True if two corners of a welded triangle coincide.
bool is_collapsed(const glm::uvec3& welded_triangle);

/// One side of one triangle, from the smaller to the larger welded vertex.
struct WeldedEdge {
  std::uint32_t low = 0, high = 0;
  std::uint32_t triangle = 0;
  bool forward = false;  ///< the triangle runs from low to high
};

/// The edges of all triangles but collapsed ones, sorted by (low, high, triangle): equal edges are neighbours.
std::vector<WeldedEdge> sorted_edges(std::span<const glm::uvec3> welded_triangles);

/// The run of equal edges that starts at `first`.
std::span<const WeldedEdge> equal_edges(std::span<const WeldedEdge> edges, std::size_t first);

}  // namespace pomona
