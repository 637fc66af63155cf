// Which way the shells of meshes face: modelling tools leave some inside out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// A shell of which it cannot be told which way it should face.
struct Undecided {
  std::int32_t surface = 0;
  glm::dvec3 place{0};  ///< of one of its triangles, metres
  std::string why;
};

struct Oriented {
  DiffusionSurfaces surfaces;
  std::vector<Undecided> undecided;
};

/// Triangles of a shell turned alike, and closed shells turned by how many others they lie in: with the side that faces
/// air outwards if the number is even, inwards, as the wall of a hollow, if it is odd. Only triangles that may turn do.
/// Shells that cross others stay as they are where they face outwards.
Oriented oriented(DiffusionSurfaces surfaces, const std::vector<std::uint8_t>& may_turn);

}  // namespace pomona
