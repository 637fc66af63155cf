// The neighbours of triangles of a solid, found by position, because vertices are duplicated where colour or normal
// changes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "generator/piece/solid.h"

namespace pomona {

struct TriangleNeighbors {
  std::vector<std::uint32_t> place_of;                ///< per vertex: the first vertex at the same position
  std::vector<std::array<std::int32_t, 3>> neighbor;  ///< per triangle, across its edge i to i + 1; -1: none
};

/// Neighbours are of one kind (both on one cut face, or both skin), share exactly one edge, and no third triangle of
/// that kind has it.
TriangleNeighbors triangle_neighbors(const Solid& solid);

}  // namespace pomona
