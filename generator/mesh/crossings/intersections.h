// The intersections between the triangles of a fruit and those of a closed knife.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/mesh/crossings/tie_rule.h"
#include "generator/mesh/overlapping_boxes.h"

namespace pomona {

/// An edge of one triangle that passes through the other.
struct Crossing {
  bool of_fruit = true;   ///< the edge is that of the fruit's triangle; else that of the knife's
  std::uint8_t edge = 0;  ///< from corner `edge` to the next
};

/// The segment in which two triangles intersect. For a viewer outside the knife, the front of the fruit's triangle is
/// left of the direction from `from` to `to`; for a viewer on that front, the knife's inside is left of it.
struct Intersection {
  std::uint32_t fruit = 0, knife = 0;
  Crossing from, to;
};

/// All intersections, sorted by the fruit's triangle, then by the knife's. By the tie rule, two triangles intersect in
/// a segment or not at all, and the crossing of an edge is the same for all triangles at the edge.
std::vector<Intersection> intersections(std::span<const Corners> fruit, std::span<const Corners> knife,
                                        Threads threads = {1});

/// The same among the pairs of a fruit's and a knife's triangle that may intersect.
std::vector<Intersection> intersections(std::span<const Corners> fruit, std::span<const Corners> knife,
                                        std::span<const BoxPair> near, Threads threads);

}  // namespace pomona
