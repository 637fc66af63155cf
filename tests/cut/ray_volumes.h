// Volumes by parallel rays, without any code of the program: neither its readers of meshes, nor its rays, nor its
// winding numbers.
#pragma once

#include <array>
#include <vector>

namespace pomona::rays {

using Point = std::array<double, 3>;
using Triangle = std::array<Point, 3>;  ///< counter-clockwise seen from air

/// Sums over the rays, cubic metres.
struct RayVolumes {
  double filled = 0;   ///< where the winding number is above 0: overlaps count once
  double counted = 0;  ///< times the winding number: overlaps count several times
  int broken = 0;      ///< rays along which entries and exits do not balance
};

/// With `across` rays along the longest side of the triangles' box, and as dense ones along the others.
RayVolumes ray_volumes(const std::vector<Triangle>& triangles, int across);

}  // namespace pomona::rays
