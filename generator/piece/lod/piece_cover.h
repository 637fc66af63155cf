// Whether every point of a triangle lies near some others: proved piece by piece.
#pragma once

#include <span>

#include "generator/mesh/box.h"
#include "generator/mesh/triangle_distance.h"

namespace pomona {

struct CoveringTriangle {
  TriangleCorners corner;
  Box<double> reach;  ///< its box, grown by the bound
};
CoveringTriangle covering_triangle(const TriangleCorners& corner, double bound);

/// Distance to a triangle is convex: a piece that has its corners near one is near it as a whole. Else it is quartered,
/// so often at most. False may mean that this was not enough.
bool is_covered(const TriangleCorners& piece, std::span<const CoveringTriangle> near, double bound, int quarterings);

}  // namespace pomona
