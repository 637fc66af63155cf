// Where surfaces cross each other.
#pragma once

#include <map>
#include <utility>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// Pairs of triangles of different surfaces that cross properly, an edge of one going through the inside of the
/// other: how many there are, by the two surfaces, the smaller index first. Grows with the square of the triangles.
std::map<std::pair<int, int>, int> crossing_triangles(const DiffusionSurfaces& surfaces);

}  // namespace pomona
