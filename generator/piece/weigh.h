// The masses of pieces, with the densities of the parts inside them.
#pragma once

#include <vector>

#include "generator/compose/grow.h"
#include "generator/piece/solid.h"

namespace pomona {

/// The pieces of a fruit; closed pieces get Solid::weighed, if the template gives parts a density of their own. Their
/// moments are those of their meshes with the fruit's density (exact), plus those of the excess densities of parts
/// (region_rays.h). The moments of all pieces add up to those of the fruit. Where the fruit has organs, with those
/// of each piece (organs.h).
std::vector<Solid> weighed(std::vector<Solid> pieces, const GrownFruit& grown, const Template& fruit);

}  // namespace pomona
