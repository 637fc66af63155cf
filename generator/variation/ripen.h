// Ripening: from the drawn colours of surfaces to those of an individual.
#pragma once

#include "generator/base/parallel.h"
#include "generator/surface/diffusion_surfaces.h"
#include "generator/surface/skin_depth.h"
#include "generator/template/template.h"

namespace pomona {

/// The ripeness, 0..2, of a point on a fruit of this ripeness: see RipenessSketch. `lateness` is clamped to 0..1.
double own_ripeness(double ripeness, double lateness, double spread);

/// The swept surfaces in the colours of `fruit.individual`. The colour of each side ripens by its part, its depth below
/// the skin and its height; then the colour shift of its part is added. Channels stay within 0..1. Colours that do not
/// change keep their bits; for an individual as drawn, these are all colours. \param skin of the whole fruit.
DiffusionSurfaces ripened(DiffusionSurfaces surfaces, const Template& fruit, const SkinDepth& skin,
                          Threads threads = {});

/// True if `ripened` changes anything.
bool has_own_colors(const Template& fruit);

}  // namespace pomona
