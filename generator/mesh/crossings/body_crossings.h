// Where the boundaries of two sets of bodies pass through each other.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/mesh/crossings/facet_parts.h"
#include "generator/mesh/overlapping_boxes.h"

namespace pomona {

/// A boundary triangle of a body; its corners, which differ, are numbers of points. It faces air.
struct BodyFacet {
  std::array<std::uint32_t, 3> corner{};
  std::int32_t body = 0;
};

/// The edge of a facet that passes through a facet of the other set.
struct EdgeCrossing {
  std::uint32_t low = 0, high = 0;  ///< the edge: numbers of its points
  std::uint32_t facet = 0;          ///< of the other set
  std::int32_t body = 0;            ///< the facet's
  std::int32_t owner = 0;           ///< the edge's
  bool enters = false;              ///< on the way from low to high
  double share = 0;                 ///< of the way from low to high
  std::uint32_t point = 0;          ///< number of the new point
};

/// The crossings of one set's facets.
struct CrossedSet {
  std::vector<std::uint32_t> crossed;  ///< facets with segments, ascending
  std::vector<CrossedFacet> facet;     ///< the same; each body that a segment is of is in the other set
  std::vector<EdgeCrossing> crossing;  ///< of its edges: by edge, then in the order along it
};

struct BodyCrossings {
  CrossedSet first, second;
};

/// The crossings by the tie rule (tie_rule.h), for which the second set is the knife: so nothing only touches.
/// Adds the new points to `place`. \param near all pairs of a first and a second facet whose boxes meet.
BodyCrossings body_crossings(std::span<const BodyFacet> first, std::span<const BodyFacet> second,
                             std::span<const BoxPair> near, std::vector<glm::dvec3>& place, Threads threads);

}  // namespace pomona
