// The cells of laws on a swept surface, which raise and paint it.
#pragma once

#include <span>
#include <vector>

#include "generator/base/random.h"
#include "generator/surface/sweep/swept_grid.h"

namespace pomona {

/// Per place, 2 d1 / (d1 + d2) of the distances of the two nearest of at least two seats: 0 at a seat, 1 between two.
std::vector<double> cell_places(std::span<const glm::dvec3> places, std::span<const glm::dvec3> seats);

/// A grid around the axis with its places in the cells of the sketch's sides, and raised as they say.
/// \throws Error (bad_data) naming the surface, if a law has fewer than two seats on it, or more than 20 000.
SweptGrid with_cells(SweptGrid grid, const Template& fruit, const SurfaceSketch& sketch, VariantKey key);

}  // namespace pomona
