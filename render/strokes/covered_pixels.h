// Rasteriser of projected triangles: a pixel is covered if its middle is inside.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "render/strokes/seen_solid.h"

namespace pomona {

/// A projected triangle.
struct PictureTriangle {
  std::array<glm::dvec3, 3> corner{};  ///< pixels, pixels, nearness (1 / metres)
  double area = 0;                     ///< twice, square pixels; above 0 where it faces the eye, 0 behind the eye

  double low(int axis) const { return std::min({corner[0][axis], corner[1][axis], corner[2][axis]}); }
  double high(int axis) const { return std::max({corner[0][axis], corner[1][axis], corner[2][axis]}); }

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
  const glm::uvec3& corner = solid.triangle[t];
  return picture_triangle({seen.vertex[corner.x], seen.vertex[corner.y], seen.vertex[corner.z]});
}

/// First and last pixel, of those from `least` to `most`, whose middle lies in [low, high].
struct PixelSpan {
  int first = 0, last = -1;
  PixelSpan(double low, double high, int least, int most)
      : first(static_cast<int>(std::clamp(std::ceil(low - 0.5), static_cast<double>(least), most + 1.0))),
        last(static_cast<int>(std::clamp(std::floor(high - 0.5), least - 1.0, static_cast<double>(most)))) {}
};

/// Columns and rows of a picture, both ends included.
struct PixelBox {
  int left = 0, top = 0, right = -1, bottom = -1;

  bool empty() const { return right < left || bottom < top; }
  int width() const { return empty() ? 0 : right - left + 1; }
  int height() const { return empty() ? 0 : bottom - top + 1; }
};

/// Calls visit(x, y, nearness) for each pixel of the box whose middle the triangle covers, edges included.
template <typename Visit>
void for_covered_pixels(const PictureTriangle& t, const PixelBox& box, Visit&& visit) {
  const PixelSpan columns(t.low(0), t.high(0), box.left, box.right);
  const PixelSpan rows(t.low(1), t.high(1), box.top, box.bottom);
  const double turn = t.area > 0 ? 1 : -1;  // the way round it is seen
  for (int y = rows.first; y <= rows.last; ++y) {
    for (int x = columns.first; x <= columns.last; ++x) {
      // A pixel is inside if its middle lies on the inner side of all three edges.
      const double px = x + 0.5, py = y + 0.5;
      std::array<double, 3> share{};
      bool inside = true;
      for (int i = 0; i < 3; ++i) {
        const glm::dvec3 &a = t.corner[(i + 1) % 3], &b = t.corner[(i + 2) % 3];
        share[i] = turn * ((px - a.x) * (b.y - a.y) - (b.x - a.x) * (py - a.y));
        inside = inside && share[i] >= 0;
      }
      if (!inside) continue;

      // Nearness is linear on the picture.
      const double sum = share[0] * t.corner[0].z + share[1] * t.corner[1].z + share[2] * t.corner[2].z;
      visit(x, y, sum / (turn * t.area));
    }
  }
}

}  // namespace pomona
