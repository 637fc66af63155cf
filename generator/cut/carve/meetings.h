// Which triangles of a fruit meet which of a closed knife.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "generator/cut/carve/tie_rule.h"

namespace pomona {

/// An edge of one triangle that passes through the other.
struct Crossing {
  bool of_fruit = true;   ///< whose edge it is
  std::uint8_t edge = 0;  ///< from corner `edge` to the next
};

/// The segment in which two triangles meet. Seen from outside the knife, the front of the fruit's triangle is left of
/// the way; seen from that front, the knife's inside is.
struct Meeting {
  std::uint32_t fruit = 0, knife = 0;
  Crossing from, to;
};

/// All meetings, by fruit triangle, then by knife triangle. By the tie rule two triangles meet in a segment or not at
/// all, and an edge's crossing is the same for all triangles at the edge.
std::vector<Meeting> meetings(std::span<const Corners> fruit, std::span<const Corners> knife);

}  // namespace pomona
