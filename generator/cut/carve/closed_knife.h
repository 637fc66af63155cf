// A closed knife, numbered.
#pragma once

#include <cstdint>

#include "generator/knife/knife_mesh.h"

namespace pomona {

/// One closed knife among all knives.
struct ClosedKnife {
  KnifeMesh mesh;
  int number = 0;            ///< among all knives
  int plane = 0;             ///< its number as one more plane, in sets of planes
  std::uint32_t stride = 1;  ///< what lies inside is in the cell with a number that is greater by this
};

}  // namespace pomona
