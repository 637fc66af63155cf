// A point that the triangulation of a cut face has added to an edge of the split mesh.
#pragma once

#include <compare>
#include <cstdint>

namespace pomona {

struct EdgePoint {
  std::uint32_t low = 0, high = 0;  ///< the edge's ends: points, low < high
  double share = 0;                 ///< 0 at low, 1 at high
  std::uint32_t point = 0;
  auto operator<=>(const EdgePoint&) const = default;
};

}  // namespace pomona
