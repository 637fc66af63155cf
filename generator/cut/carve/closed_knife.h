// A closed knife, numbered.
#pragma once

#include <cstdint>

#include "generator/knife/knife_mesh.h"

namespace pomona {

/// One closed knife among all knives.
struct ClosedKnife {
  KnifeMesh mesh;
  int number = 0;            ///< among all knives
  int plane = 0;             ///< its number in sets of planes, where it counts as one more plane
  std::uint32_t stride = 1;  ///< the number of a cell inside the knife is larger by this
};

}  // namespace pomona
