// Which vertices of a mesh are connected by its triangles.
#pragma once

#include <cstddef>
#include <span>

#include <glm/vec3.hpp>

#include "generator/mesh/disjoint_sets.h"

namespace pomona {

/// A set for each connected part; a vertex of no triangle is one by itself. Vertices at equal positions are not joined.
inline DisjointSets connected_vertices(std::size_t vertices, std::span<const glm::uvec3> triangles) {
  DisjointSets sets(vertices);
  for (const glm::uvec3& t : triangles) {
    sets.join(t.x, t.y);
    sets.join(t.x, t.z);
  }
  return sets;
}

}  // namespace pomona
