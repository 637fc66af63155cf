// The fruit without its skin: what a peeler leaves.
#pragma once

#include "generator/mesh/closed_surface.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

struct PeelOptions {
  double thickness = 2e-3;  ///< metres
  double strip = 0;         ///< width of one strip in a spiral about the axis, metres; 0 = no spiral
};

/// The surface along which a peeler cuts: the fruit's main body offset inwards, and around the kept bodies
/// (peel_depth.h). The peel lies outside it. Between the turns of a strip a ridge of the fruit remains, a thirtieth as
/// wide as the strip, so that the strip is connected but does not touch itself. The error is about 0.03 mm on a ball of
/// 70 mm: vertices lie on the offset (with a ridge, up to the curvature within a cell of the grid), and triangles
/// differ from it by as much. Triangles cut off the creases of the offset. \throws Error (usage) for a peel thicker
/// than the fruit and a strip too narrow; (bad_data) for an open skin.
ClosedSurface peeled(const DiffusionSurfaces& surfaces, const PeelOptions& options);

}  // namespace pomona
