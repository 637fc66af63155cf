// Where swept surfaces cross each other.
#pragma once

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// Pairs of triangles of different surfaces that cross properly: an edge of one goes through the inside of the other.
int crossing_triangles(const DiffusionSurfaces& surfaces);

}  // namespace pomona
