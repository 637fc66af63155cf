// The edges of a triangle soup: which triangles meet at each, and which way round. A sorted list of half-edges instead
// of a half-edge structure, because imported surfaces may branch, cross and repeat themselves, which such a structure
// refuses. Vertices are one if their numbers are equal: weld() first where equal positions are to be one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace pomona {

/// One side of one triangle.
struct HalfEdge {
  std::int32_t kind = 0;            ///< kind of the triangle
  std::uint32_t low = 0, high = 0;  ///< its ends, the smaller vertex first
  std::uint32_t triangle = 0;
  std::uint8_t side = 0;  ///< it goes from the triangle's corner `side` to the next one
  bool forward = false;   ///< the triangle runs it from low to high
};

struct HalfEdgeOptions {
  std::span<const std::int32_t> kind = {};  ///< per triangle: those of different kinds share no edge; empty: all do
  bool of_collapsed = false;  ///< also those of triangles with two corners in one vertex, where the ends are two
};

/// All half-edges sorted by (kind, low, high, triangle, side): those of one edge follow each other.
std::vector<HalfEdge> sorted_half_edges(std::span<const glm::uvec3> triangles, const HalfEdgeOptions& options = {});

/// The run of half-edges of one edge that starts at `first`.
std::span<const HalfEdge> edge_at(std::span<const HalfEdge> sorted, std::size_t first);

/// Calls visit(span of half-edges) for every edge, in their order.
template <typename Visit>
void for_each_edge(std::span<const HalfEdge> sorted, const Visit& visit) {
  for (std::size_t first = 0; first < sorted.size();) {
    const std::span<const HalfEdge> edge = edge_at(sorted, first);
    visit(edge);
    first += edge.size();
  }
}

/// How many more triangles run the edge from low to high than back; 0 where they match each other.
int balance(std::span<const HalfEdge> edge);

/// True if all edges are in balance: the triangles bound a solid.
bool is_closed(std::span<const glm::uvec3> triangles);

/// The vertices at the half-edge's low and high end in other triangles of the same order: those before welding.
glm::uvec2 ends_in(std::span<const glm::uvec3> triangles, const HalfEdge& half_edge);

/// True if two corners of a triangle are one vertex.
bool is_collapsed(const glm::uvec3& triangle);

}  // namespace pomona
