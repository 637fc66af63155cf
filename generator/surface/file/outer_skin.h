// Finds the skin of surfaces that do not say which side faces air.
#pragma once

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// Hides the outer side of every closed shell that lies in no other shell. A shell that crosses others counts as inside
/// if most of it is inside. Vertices that the skin shares with inner triangles are duplicated, at the end. The surfaces
/// are not changed if any vertex is hidden already, or if no shell is closed.
DiffusionSurfaces with_outer_skin(DiffusionSurfaces surfaces);

}  // namespace pomona
