// Facts of a piece: its size, its mass, its position.
#pragma once

#include <cstddef>

#include "generator/piece/solid.h"

namespace pomona {

struct PieceFacts {
  double volume = 0;           ///< cubic metres
  double mass = 0;             ///< kilograms; parts inside may have densities of their own
  double density = 0;          ///< mean, kilograms per cubic metre
  glm::dvec3 center{0};        ///< centre of mass; if the volume is 0, centre of the bounding box
  glm::dmat3 inertia{0};       ///< about the centre of mass, along the fruit's axes, kg m^2; zero if the volume is 0
  glm::dvec3 low{0}, high{0};  ///< bounding box
  std::size_t triangles = 0;
};

/// The facts, in the frame in which the piece grew. The volume of an open piece is that between its triangles and the
/// origin.
PieceFacts facts_of(const Solid& solid);

}  // namespace pomona
