// The masses of pieces, with the densities of the parts inside them.
#pragma once

#include <vector>

#include "generator/compose/grow.h"
#include "generator/piece/solid.h"
#include "generator/surface/part_regions.h"

namespace pomona {

/// The pieces of a fruit; closed pieces get Solid::weighed, if the template gives parts a density of their own. Their
/// moments are those of their meshes with the fruit's density (exact), plus those of the excess densities of parts
/// (region_rays.h). The moments of all pieces add up to those of the fruit.
std::vector<Solid> weighed(std::vector<Solid> pieces, const GrownFruit& grown, const Template& fruit);

/// Per region, by how much its part is denser than the fruit, kg per cubic metre.
std::vector<double> excess_densities(const PartRegions& regions, const Template& fruit);

}  // namespace pomona
