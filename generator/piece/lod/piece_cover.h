// Proves piece by piece that every point of a triangle lies near other triangles.
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

/// Distance to a triangle is convex, so a piece with all corners near one triangle is near it as a whole. Other pieces
/// are quartered, up to a given number of times. False may mean that this was not enough.
bool is_covered(const TriangleCorners& piece, std::span<const CoveringTriangle> near, double bound, int quarterings);

}  // namespace pomona
