// A skin for surfaces that say nowhere which side faces air.
#pragma once

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// Hides the outer side of every closed shell that lies in no other; a shell that crosses others counts as
/// inside where most of it is. Vertices which the skin shares with inner triangles are doubled, at the end.
/// Unchanged where any vertex is hidden already, or nothing is closed.
DiffusionSurfaces with_outer_skin(DiffusionSurfaces surfaces);

}  // namespace pomona
