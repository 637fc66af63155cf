// Orients the shells of meshes, because modelling tools leave some inside out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// A shell whose orientation cannot be decided.
struct Undecided {
  std::int32_t surface = 0;
  glm::dvec3 place{0};  ///< place of one of its triangles, metres
  std::string why;
};

struct Oriented {
  DiffusionSurfaces surfaces;
  std::vector<Undecided> undecided;
};

/// Orients the triangles of each shell alike, and closed shells by the number of others around them: the side that
/// faces air looks outwards if it is even, inwards, as the wall of a hollow, if it is odd. Only larger shells count as
/// around; of equal ones at one place within a solid one is a wall, and the other fills its hollow; in air the others
/// are left out. Only triangles that may turn do. Shells that cross others keep an outward orientation. What shares
/// edges is told apart first (turns_where_solids_touch).
Oriented oriented(DiffusionSurfaces surfaces, const std::vector<std::uint8_t>& may_turn);

}  // namespace pomona
