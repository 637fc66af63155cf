// The union of two sets of bodies; within each set none overlap.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/mesh/crossings/body_crossings.h"

namespace pomona {

/// The result for the facets of one set.
struct UnitedFacets {
  std::vector<std::vector<FacetPart>> part;  ///< per facet: its parts; none if nothing crosses it
  std::vector<std::int32_t> inside;          ///< per facet that nothing crosses: the body it lies in, or outside
};

struct LayerUnion {
  UnitedFacets first, second;
};

struct LayerTask {
  std::span<const BodyFacet> first, second;
  std::span<const BoxPair> near;  ///< all pairs of a first and a second facet whose boxes meet

  /// The body of the other set in which an uncrossed facet lies, or outside.
  std::function<std::int32_t(bool of_first, std::uint32_t facet)> body_around;

  /// Overlaps of a body of the second set that have less volume than this, cubic metres, only touch.
  std::function<double(std::int32_t body)> least_overlap;
};

/// Bodies of the second set stay as they are if they only touch, or cross a body where it crosses itself.
/// Adds new points to `place`.
LayerUnion layer_union(const LayerTask& task, std::vector<glm::dvec3>& place, Threads threads);

}  // namespace pomona
