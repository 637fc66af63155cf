// Finds the skin of surfaces that do not say which side faces air.
#pragma once

#include <cstddef>
#include <optional>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// Hides the outer side of every closed shell that lies in no other shell. A shell that crosses others counts as inside
/// if most of it is inside. Vertices that the skin shares with inner triangles are duplicated, at the end. The surfaces
/// are not changed if any vertex is hidden already, or if no shell is closed.
DiffusionSurfaces with_outer_skin(DiffusionSurfaces surfaces);

/// The first triangle of a closed shell whose hidden side faces inwards although no other shell lies around it: nothing
/// of it is solid. Nothing if there is no such shell.
std::optional<std::size_t> shell_inside_out(const DiffusionSurfaces& surfaces);

}  // namespace pomona
