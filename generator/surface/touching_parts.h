// Parts of a mesh in which solids share edges and face different ways.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/mesh/edges.h"
#include "generator/mesh/enclosures.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// Surfaces, their triangles welded and facing air, and the edges of these.
struct EdgedMesh {
  const DiffusionSurfaces& surfaces;
  std::span<const glm::uvec3> triangles;
  std::vector<HalfEdge> half_edges;  ///< sorted

  glm::dvec3 corner(std::uint32_t triangle, int k) const {
    return glm::dvec3(surfaces.position[triangles[triangle][k]]);
  }
};

/// A part is what hangs together by shared edges; its number is that of its first triangle.
struct TouchingParts {
  std::vector<std::uint32_t> of_triangle;
  std::vector<std::uint8_t> is_wrong;  ///< per part: solids in it face different ways
  Enclosures space;                    ///< of all parts that may be wrong

  bool holds_wrong(std::uint32_t triangle) const { return is_wrong[of_triangle[triangle]] != 0; }
  bool any_wrong() const;
};

/// A part is wrong if two of its triangles face alike at one place, or if it winds somewhere less often than not at
/// all. Parts with an odd number of triangles at some edge are left alone, and those with more than 64: no solids.
TouchingParts touching_parts(const EdgedMesh& mesh);

/// How often the triangle's part winds around the places just in front of it and just behind it; nothing for a triangle
/// without area.
std::optional<std::array<int, 2>> windings_beside(const EdgedMesh& mesh, const TouchingParts& parts,
                                                  std::uint32_t triangle);

}  // namespace pomona
