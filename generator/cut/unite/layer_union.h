// The union of bodies that do not overlap each other with further ones that do not either.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/cut/unite/body_crossings.h"

namespace pomona {

/// What is left of the facets of one set.
struct UnitedFacets {
  std::vector<std::vector<FacetPart>> part;  ///< per facet: its parts; none if nothing crosses it
  std::vector<std::int32_t> inside;          ///< per facet that nothing crosses: the body it lies in, or outside
};

struct LayerUnion {
  UnitedFacets first, second;
};

struct LayerTask {
  std::span<const BodyFacet> first, second;

  /// The body of the other set that a facet lies in, or outside; asked for facets that nothing crosses.
  std::function<std::int32_t(bool of_first, std::uint32_t facet)> body_around;

  /// Overlaps of a body of the second set that have less volume than this, cubic metres, only touch.
  std::function<double(std::int32_t body)> least_overlap;
};

/// A body of the second set that only touches, or that crosses what crosses itself, is left as it is.
/// Adds new points to `place`.
LayerUnion layer_union(const LayerTask& task, std::vector<glm::dvec3>& place, Threads threads);

}  // namespace pomona
