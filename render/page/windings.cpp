#include "render/page/windings.h"

#include <algorithm>
#include <array>

namespace pomona {

namespace {

struct Corner {
  std::int64_t x = 0, y = 0, z = 0;
};

std::int64_t floor_of(std::int64_t a, std::int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }
std::int64_t ceiling_of(std::int64_t a, std::int64_t b) { return -floor_of(-a, b); }

/// Twice the area of a, b and the row at (y, z), seen along x.
std::int64_t area(const Corner& a, const Corner& b, std::int64_t y, std::int64_t z) {
  return (b.y - a.y) * (z - a.z) - (b.z - a.z) * (y - a.y);
}

/// The side of a -> b on which the row passes: both triangles at an edge get the same answer, never "on it".
bool is_left(const Corner& a, const Corner& b, std::int64_t y, std::int64_t z) {
  if (b.z < a.z || (b.z == a.z && b.y < a.y)) return !is_left(b, a, y, z);
  const std::int64_t twice = area(a, b, y, z);
  if (twice != 0) return twice > 0;
  return a.z == b.z && b.y > a.y;
}

/// Rows of nodes from first to last, last included, along y and z; none if last is below first.
struct NodeRows {
  std::int64_t first_y, last_y, first_z, last_z;
  std::int64_t count() const {
    return std::max<std::int64_t>(last_y - first_y + 1, 0) * std::max<std::int64_t>(last_z - first_z + 1, 0);
  }
};

/// The rows in the box of a triangle.
NodeRows rows_near(const std::array<Corner, 3>& t, const Asset& asset) {
  const auto& [a, b, c] = t;
  const std::int64_t step = 2 * asset.units;
  return {ceiling_of(std::min({a.y, b.y, c.y}), step),
          std::min<std::int64_t>(floor_of(std::max({a.y, b.y, c.y}), step), asset.count[1] - 1),
          ceiling_of(std::min({a.z, b.z, c.z}), step),
          std::min<std::int64_t>(floor_of(std::max({a.z, b.z, c.z}), step), asset.count[2] - 1)};
}

/// Adds the change of one triangle along the rows that cross it, from the first node beyond it on.
void add_crossings(const std::array<Corner, 3>& t, const Asset& asset, std::vector<std::int8_t>& change) {
  const auto& [a, b, c] = t;
  const std::int64_t step = 2 * asset.units;
  const std::int64_t nx = asset.count[0], ny = asset.count[1];
  const NodeRows rows = rows_near(t, asset);
  for (std::int64_t iz = rows.first_z; iz <= rows.last_z; ++iz) {
    for (std::int64_t iy = rows.first_y; iy <= rows.last_y; ++iy) {
      const std::int64_t y = iy * step, z = iz * step;
      const bool left = is_left(a, b, y, z);
      if (is_left(b, c, y, z) != left || is_left(c, a, y, z) != left) continue;

      // The crossing as weights of the corners; an edge-on triangle counts as its first corner.
      const double e1 = static_cast<double>(area(a, b, y, z)), e2 = static_cast<double>(area(b, c, y, z));
      const double e3 = static_cast<double>(area(c, a, y, z)), sum = e1 + e2 + e3;
      const double x =
          sum == 0
              ? static_cast<double>(a.x)
              : (e2 * static_cast<double>(a.x) + e3 * static_cast<double>(b.x) + e1 * static_cast<double>(c.x)) / sum;
      const std::int64_t first =
          std::max<std::int64_t>(0, static_cast<std::int64_t>(x / static_cast<double>(step)) + 1);
      if (first >= nx) continue;
      std::int8_t& at = change[static_cast<std::size_t>((iz * ny + iy) * nx + first)];
      at = static_cast<std::int8_t>(at + (left ? -1 : 1));
    }
  }
}

/// The triangle, counter-clockwise seen from air.
std::array<Corner, 3> corners_of(const Asset& asset, std::size_t t) {
  const auto corner = [&](std::uint32_t v) {
    const glm::u16vec3& q = asset.position[v];
    return Corner{2 * q.x + 1, 2 * q.y + 1, 2 * q.z + 1};
  };
  const glm::uvec3& v = asset.triangle[t];
  const bool turned = asset.hidden[t] == 2;
  return {corner(v.x), corner(turned ? v.z : v.y), corner(turned ? v.y : v.z)};
}

}  // namespace

std::int64_t rows_to_ask(const Asset& asset) {
  std::int64_t rows = 0;
  for (std::size_t t = 0; t < asset.triangle.size(); ++t)
    if (asset.hidden[t] != 0) rows += rows_near(corners_of(asset, t), asset).count();
  return rows;
}

std::vector<std::int8_t> windings(const Asset& asset) {
  std::vector<std::int8_t> winding(asset.node_count(), 0);
  for (std::size_t t = 0; t < asset.triangle.size(); ++t)
    if (asset.hidden[t] != 0) add_crossings(corners_of(asset, t), asset, winding);
  const auto nx = static_cast<std::size_t>(asset.count[0]);
  for (std::size_t row = 0; row < winding.size(); row += nx) {
    for (std::size_t x = 1; x < nx; ++x)
      winding[row + x] = static_cast<std::int8_t>(winding[row + x] + winding[row + x - 1]);
  }
  return winding;
}

}  // namespace pomona
