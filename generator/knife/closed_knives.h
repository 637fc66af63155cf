// Closed knives placed at a fruit: balls, corers, bites, drawn profiles and peelers become closed surfaces.
#pragma once

#include "generator/knife/knife.h"
#include "generator/mesh/closed_surface.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// The closed surface along which this knife cuts. For a peeler, the fruit inside it remains; for all other knives, the
/// fruit inside it is taken out.
/// \throws Error (usage) for a peel thicker than the fruit, and for a profile that needs too many triangles; (bad_data)
/// for a peel of a skin that is open.
ClosedSurface surface_of(const ClosedCut& knife, const DiffusionSurfaces& surfaces);

}  // namespace pomona
