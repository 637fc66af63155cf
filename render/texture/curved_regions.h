// Divides skin and curved cut faces into regions that face one direction, to be flattened one by one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "render/texture/triangle_neighbors.h"

namespace pomona {

struct CurvedRegion {
  std::vector<std::uint32_t> triangles;  ///< triangles of the solid, ascending
  glm::dvec3 normal{0, 1, 0};            ///< unit; all triangles with an area face it by less than a right angle
};

/// Puts every triangle marked by `is_curved` into one region; each region is connected and of one kind. Regions grow
/// from their middle outwards, in the order of their normals, up to 63 degrees from it [variational shape
/// approximation, Cohen-Steiner et al. 2004]. They grow again from their mean normals, and are joined if the union is
/// within 72 degrees.
std::vector<CurvedRegion> curved_regions(const Solid& solid, const TriangleNeighbors& neighbors,
                                         std::span<const std::uint8_t> is_curved);

}  // namespace pomona
