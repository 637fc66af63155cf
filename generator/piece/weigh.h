// What pieces weigh, by the parts inside them.
#pragma once

#include <vector>

#include "generator/piece/grow.h"
#include "generator/piece/solid.h"

namespace pomona {

/// Closed pieces of a fruit with Solid::weighed, where the template gives parts a density of their own; others as they
/// are. Their moments are those of their meshes at the fruit's density, exactly, and to that what its parts exceed it
/// by (region_rays.h). Pieces of one fruit add up to it.
std::vector<Solid> weighed(std::vector<Solid> pieces, const GrownFruit& grown, const Template& fruit);

}  // namespace pomona
