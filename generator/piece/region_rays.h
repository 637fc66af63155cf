// How much denser or lighter than usual pieces are, by the parts inside them.
#pragma once

#include <span>
#include <vector>

#include "generator/mesh/moments.h"
#include "generator/piece/solid.h"
#include "generator/surface/part_regions.h"

namespace pomona {

struct RegionRayOptions {
  int rays = 4000;  ///< through the box around all regions; masses of pieces are then right to half a hundredth
};

/// Per piece, the moments of the density by which its parts exceed the usual one.
///
/// Neither regions nor pieces need to nest: grains stick out of what they grow on, seeds touch each other. So it is not
/// summed over polyhedra, but along parallel rays on a lattice: exactly along each ray, by the midpoint rule across.
/// The rays go in a direction that no knife has, so that cuts are no steps of the lattice; and they are the same for
/// all pieces of a fruit, so that what pieces have adds up to what the fruit has, to rounding. Open pieces have none.
/// \param excess per region, kg per cubic metre. \param origin of the moments.
std::vector<Moments> excess_moments(std::span<const Solid> pieces, const PartRegions& regions,
                                    std::span<const double> excess, const glm::dvec3& origin,
                                    const RegionRayOptions& options = {});

}  // namespace pomona
