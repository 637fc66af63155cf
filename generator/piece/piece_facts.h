// What there is to know of a piece: how large, how heavy, where.
#pragma once

#include <cstddef>

#include "generator/piece/solid.h"

namespace pomona {

struct PieceFacts {
  double volume = 0;           ///< cubic metres
  double mass = 0;             ///< kilograms, of Solid::density
  glm::dvec3 center{0};        ///< of mass, all of it equally dense; of the bounding box where there is no volume
  glm::dvec3 low{0}, high{0};  ///< bounding box
  std::size_t triangles = 0;
};

/// In the frame the piece grew in. Of an open piece volume and mass are what its triangles enclose with the origin.
PieceFacts facts_of(const Solid& solid);

}  // namespace pomona
