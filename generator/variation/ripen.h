// Ripening: from surfaces in their drawn colours to those of an individual.
#pragma once

#include "generator/base/parallel.h"
#include "generator/surface/diffusion_surfaces.h"
#include "generator/surface/skin_depth.h"
#include "generator/template/template.h"

namespace pomona {

/// A place's own ripeness, 0..2, on a fruit of this ripeness: see RipenessSketch. `lateness` is taken within 0..1.
double own_ripeness(double ripeness, double lateness, double spread);

/// The surfaces, fresh from the sweep, in the colours of `fruit.individual`: every side's colour ripens by its part,
/// its depth below the skin and its height, and takes the shift of its part. Colours stay within 0..1 a channel.
/// What neither changes keeps its bits; an individual as drawn, all of them. `skin`: of the whole fruit.
DiffusionSurfaces ripened(DiffusionSurfaces surfaces, const Template& fruit, const SkinDepth& skin,
                          Threads threads = {});

/// True if `ripened` changes anything.
bool has_own_colors(const Template& fruit);

}  // namespace pomona
