// What there is to know of a piece: how large, how heavy, where.
#pragma once

#include <cstddef>

#include "generator/piece/solid.h"

namespace pomona {

struct PieceFacts {
  double volume = 0;      ///< cubic metres
  double mass = 0;        ///< kilograms, by the parts inside where these have densities of their own
  double density = 0;     ///< mean, kilograms per cubic metre
  glm::dvec3 center{0};   ///< of mass; of the bounding box where there is no volume
  glm::dmat3 inertia{0};  ///< about the centre of mass, kg m^2, along the fruit's axes; zero where there is no volume
  glm::dvec3 low{0}, high{0};  ///< bounding box
  std::size_t triangles = 0;
};

/// In the frame the piece grew in. Of an open piece volume and mass are what its triangles enclose with the origin.
PieceFacts facts_of(const Solid& solid);

}  // namespace pomona
