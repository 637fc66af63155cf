#include "generator/diffusion/pmvc/cube_directions.h"

#include <cmath>

#include "generator/base/reproducible.h"

namespace pomona {

namespace {

/// Solid angle of the rectangle from (0, 0) to (u, v) at distance 1.
double corner_angle(double u, double v) { return reproducible::atan2(u * v, std::sqrt(u * u + v * v + 1)); }

}  // namespace

CubeFace make_cube_face(int texels) {
  CubeFace face;
  face.texels = texels;
  for (int i = 0; i < texels; ++i) face.middle.push_back((2 * i + 1) / static_cast<double>(texels) - 1);

  const double half = 1.0 / texels;
  for (const double v : face.middle) {
    for (const double u : face.middle) {
      // Uses the symmetry of the arguments, so that opposite texels get the same bits.
      const double x = std::fabs(u), y = std::fabs(v);
      face.solid_angle.push_back(corner_angle(x - half, y - half) - corner_angle(x - half, y + half) -
                                 corner_angle(x + half, y - half) + corner_angle(x + half, y + half));
      face.length.push_back(std::sqrt(u * u + v * v + 1));
    }
  }
  return face;
}

}  // namespace pomona
