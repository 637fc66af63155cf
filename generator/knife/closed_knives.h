// Closed knives laid at a fruit: balls, corers, bites, drawn profiles and peelers become closed surfaces.
#pragma once

#include "generator/knife/knife.h"
#include "generator/mesh/closed_surface.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// The closed surface along which this knife cuts. What lies inside it is, for a peeler, the fruit that is left, and
/// what is taken out for all others. \throws Error (usage) for what cannot be cut: a peel thicker than the fruit, a
/// profile that needs too many triangles, and (bad_data) a peel of a skin that is open.
ClosedSurface surface_of(const ClosedCut& knife, const DiffusionSurfaces& surfaces);

}  // namespace pomona
