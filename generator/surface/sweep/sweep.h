// Sweeps: from a template's curves to its diffusion surfaces (paper, section 4.1, Figures 6 and 7).
#pragma once

#include "generator/surface/diffusion_surfaces.h"
#include "generator/surface/sweep/sweep_options.h"
#include "generator/template/template.h"

namespace pomona {

/// Sweeps every surface of the template, in order, and paints it; then adds its meshes. Without grains, and before
/// sheets(). The triangles depend only on the template's counts, the number of folds and the detail, so all variants
/// have the same. \throws Error (bad_data) naming template and surface where curves cannot be swept, or there are too
/// many spots.
DiffusionSurfaces sweep(const Template& fruit, const SweepOptions& options = {});

}  // namespace pomona
