// The shapes of grains.
#pragma once

#include "generator/surface/sweep/swept_grid.h"

namespace pomona {

/// One grain of length 2 along +Y, its tip up, and radius 1 across, thickness along X and width along Z. Closed;
/// its vertices lie on the shape, which is the image of a sphere.
SweptGrid unit_grain(const GrainForm& form);

/// How far a shape sticks out of the ellipsoid of its axes, as a factor of them.
double bulge_of(GrainShape shape);

}  // namespace pomona
