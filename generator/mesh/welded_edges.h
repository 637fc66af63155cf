// For users that are still to learn the new names.
#pragma once

#include "generator/mesh/edges.h"
#include "generator/mesh/weld.h"

namespace pomona {

using WeldedEdge = HalfEdge;
inline std::vector<HalfEdge> sorted_edges(std::span<const glm::uvec3> triangles) {
  return sorted_half_edges(triangles);
}
inline std::span<const HalfEdge> equal_edges(std::span<const HalfEdge> edges, std::size_t first) {
  return edge_at(edges, first);
}

}  // namespace pomona
