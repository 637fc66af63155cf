// The difference in mass of pieces from parts inside them that are denser or lighter than the rest.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "generator/mesh/enclosures.h"
#include "generator/mesh/moments.h"
#include "generator/piece/solid.h"
#include "generator/surface/part_regions.h"

namespace pomona {

struct RegionRayOptions {
  int rays = 4000;  ///< number of rays through the box around all regions; the error of masses is then half a percent
};

/// Per piece, the moments of the excess density of its parts.
///
/// Regions and pieces need not be nested: grains stick out of what they grow on, seeds touch each other. So the moments
/// are not summed over polyhedra, but along parallel rays on a lattice: exactly along each ray, by the midpoint rule
/// across. No knife has the direction of the rays, so cuts are not aligned with the lattice. The rays are the same for
/// all pieces of a fruit, so the moments of the pieces add up to those of the fruit, up to rounding. Open pieces have
/// none. \param excess per region, kg per cubic metre. \param origin of the moments.
std::vector<Moments> excess_moments(std::span<const Solid> pieces, const PartRegions& regions,
                                    std::span<const double> excess, const glm::dvec3& origin,
                                    const RegionRayOptions& options = {});

/// Per piece the volume that it has of each organ, along such rays: that of 0 where its skin is around a place, else of
/// the last one around it. Open pieces have none.
/// \param skins their `mesh` is the organ's number; 0: the fruit itself
std::vector<std::map<std::int32_t, double>> organ_ray_volumes(std::span<const Solid> pieces,
                                                              std::span<const Enclosures::Triangle> skins,
                                                              const RegionRayOptions& options);

}  // namespace pomona
