// The fruit less its skin: what a peeler leaves.
#pragma once

#include "generator/mesh/closed_surface.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

struct PeelOptions {
  double thickness = 2e-3;  ///< metres
  double strip = 0;         ///< width of one strip in a spiral about the axis, metres; 0 = no spiral
};

/// The surface along which a peeler cuts: the fruit's main body offset inwards, and around what stays (peel_depth.h).
/// The peel is what lies outside it. Between the turns of a strip a ridge stays with the fruit, a thirtieth as wide as
/// the strip, so that the strip hangs together but does not touch itself.
/// Vertices lie on the offset, with a ridge up to the curvature within a cell of the grid; triangles stray from it by
/// as much: some 0.03 mm on a ball of 70 mm. Where the offset is creased they cut the crease off.
/// \throws Error (usage) for a peel thicker than the fruit and a strip too narrow; (bad_data) for an open skin.
ClosedSurface peeled(const DiffusionSurfaces& surfaces, const PeelOptions& options);

}  // namespace pomona
