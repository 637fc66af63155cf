// What is solid along parallel rays: volumes found with no code of the program's, neither its readers of meshes, nor
// its rays, nor its windings.
#pragma once

#include <array>
#include <vector>

namespace pomona::rays {

using Point = std::array<double, 3>;
using Triangle = std::array<Point, 3>;  ///< counter-clockwise seen from air

/// Sums over the rays, cubic metres.
struct RayVolumes {
  double filled = 0;   ///< where the winding number is above 0: what overlaps counts once
  double counted = 0;  ///< times the winding number: what overlaps counts as often as it does
  int broken = 0;      ///< rays along which entries and exits do not balance
};

/// By `across` rays along the longest side of the triangles' box, and as many as that gives along the others.
RayVolumes ray_volumes(const std::vector<Triangle>& triangles, int across);

}  // namespace pomona::rays
