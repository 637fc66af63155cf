// Guides for texture detail on a grid, for cuts that are not known yet.
#pragma once

#include "generator/base/parallel.h"
#include "generator/compose/grow.h"
#include "generator/template/template.h"
#include "render/page/asset.h"

namespace pomona {

/// Adds `guide` if the template has details for cut faces, and `skin_share` if it has some for skins. Outside the
/// fruit, where the corners of cells at the skin lie, the way to the skin leads back inwards, so that it is 0 on the
/// skin between them.
void add_guide(const GrownFruit& grown, const Template& fruit, Threads threads, Asset& asset);

}  // namespace pomona
