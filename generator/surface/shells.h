// Shells: the connected surfaces that boundary triangles form across welded edges.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// The shells of all boundary triangles, ordered by their first triangle.
struct Shells {
  static constexpr std::int32_t none = -1;

  std::vector<std::int32_t> of_triangle;    ///< `none` for inner triangles
  std::vector<std::uint8_t> closed;         ///< per shell: every edge is matched by an opposite one
  std::vector<std::int32_t> open_surfaces;  ///< surfaces with an unmatched edge, ascending
  std::vector<glm::uvec3> air_facing;       ///< per triangle: welded, counter-clockwise seen from air
  std::size_t count() const { return closed.size(); }
};

/// Where more than two triangles share an edge, those that bound one wedge of solid belong together, so that bodies
/// that touch along an edge are different bodies.
Shells find_shells(const DiffusionSurfaces& surfaces);

}  // namespace pomona
