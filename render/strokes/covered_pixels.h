// Rasteriser of projected triangles: a pixel is covered if its middle is inside.
#pragma once

#include <array>
#include <cstdint>

#include "render/image/triangle_raster.h"
#include "render/strokes/seen_solid.h"

namespace pomona {

/// A projected triangle.
struct PictureTriangle {
  std::array<glm::dvec3, 3> corner{};  ///< pixels, pixels, nearness (1 / metres)
  double area = 0;                     ///< twice, square pixels; above 0 where it faces the eye, 0 behind the eye

  TriangleRaster<double> raster() const { return {corner[0], corner[1], corner[2]}; }

  /// Triangles of a closed solid that face away are hidden.
  bool can_be_seen(bool closed) const { return closed ? area > 0 : area != 0; }
};

/// The triangle from its corners, as given by Lens::seen(). A triangle that reaches behind the eye has area 0.
inline PictureTriangle picture_triangle(const std::array<glm::dvec3, 3>& seen) {
  PictureTriangle result;
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3& v = seen[i];
    if (!(v.z > 0)) return {};
    result.corner[i] = {v.x, v.y, 1 / v.z};
  }
  const glm::dvec3 &a = result.corner[0], &b = result.corner[1], &c = result.corner[2];
  result.area = (c.x - a.x) * (b.y - a.y) - (b.x - a.x) * (c.y - a.y);
  return result;
}

/// Triangle `t` of a solid.
inline PictureTriangle picture_triangle(const Solid& solid, const SeenSolid& seen, std::uint32_t t) {
  const glm::uvec3& corner = solid.mesh.triangle[t];
  return picture_triangle({seen.vertex[corner.x], seen.vertex[corner.y], seen.vertex[corner.z]});
}

/// The middles of a picture's pixels.
inline RasterSamples<double> pixel_middles(const PixelBox& box) { return {0.5, 1, box}; }

/// Calls visit(x, y, nearness) for each pixel of the box whose middle the triangle covers, edges included.
template <typename Visit>
void for_covered_pixels(const PictureTriangle& t, const PixelBox& box, const Visit& visit) {
  // Nearness is linear on the picture.
  const TriangleRaster<double> raster = t.raster();
  raster.for_covered(pixel_middles(box), [&](int x, int y, const glm::dvec3& share) {
    const double sum = share.x * t.corner[0].z + share.y * t.corner[1].z + share.z * t.corner[2].z;
    visit(x, y, sum / raster.area());
  });
}

}  // namespace pomona
