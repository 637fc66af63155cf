// Which triangles face the wrong way where solids of one mesh share edges and faces.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// Per triangle 1 if it must turn. Where solids share an edge, the way in which triangles face tells which of them
/// belong together, so solids that face different ways cannot even be told apart. There the space itself decides: what
/// lies within an odd number of closed surfaces is solid, and a triangle faces the side that is not. Of two triangles
/// at one place each faces the other's solid. Only what hangs together by shared edges is looked at, and of that only
/// what has an even number of triangles at each edge, and two that face alike at one place, or places around which it
/// winds less often than not at all.
/// \param triangles of the surfaces, welded, facing air; those that may not turn collapsed
std::vector<std::uint8_t> turns_where_solids_touch(const DiffusionSurfaces& surfaces,
                                                   std::span<const glm::uvec3> triangles);

}  // namespace pomona
