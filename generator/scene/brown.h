// Browning: cut faces that have lain in air.
#pragma once

#include "generator/cut/cross_section.h"
#include "generator/surface/diffusion_surfaces.h"
#include "generator/template/template.h"

namespace pomona {

/// The section, its colours diffused, as brown as `fruit.individual` says: see BrowningSketch. The field is tied to
/// the fruit, not to the cut: two cuts agree at every vertex where they meet. Only colours change, and only
/// towards those of the sketch; at browning 0 they keep their bits. `surfaces`: those that were cut.
CrossSection browned(CrossSection section, const DiffusionSurfaces& surfaces, const Template& fruit);

}  // namespace pomona
