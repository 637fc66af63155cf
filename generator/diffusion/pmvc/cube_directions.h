// The directions of a world-aligned cube around a point, with their solid angles.
#pragma once

#include <vector>

namespace pomona {

/// One face of a cube of directions (u, v, 1), u and v at the middles of `texels` x `texels` squares that fill
/// [-1, 1]^2; the other five faces are its permutations. Opposite faces mirror each other, so that the sum of
/// all directions times solid angles is zero: that makes positive mean values exact on linear fields in closed
/// scenes.
struct CubeFace {
  int texels = 0;
  std::vector<double> middle;       ///< `texels` values of u (and of v)
  std::vector<double> solid_angle;  ///< texels^2, row by row (v); all six faces add up to 4 pi
  std::vector<double> length;       ///< length of (u, v, 1), likewise
};

/// Exact solid angles, after [Driscoll, Cubemap Texel Solid Angle, 2012].
CubeFace make_cube_face(int texels);

}  // namespace pomona
