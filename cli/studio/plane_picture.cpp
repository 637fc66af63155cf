#include "cli/studio/plane_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

/// Where a row crosses the boundary: the place in pixels, and +1 where the row enters the fruit, -1 where it leaves it.
struct RowCrossing {
  double place = 0;
  int turn = 0;
};
using Rows = std::vector<std::vector<RowCrossing>>;

/// A point of the boundary in the frame: x and y in pixels, z the distance from the plane.
glm::dvec3 in_frame(const PictureFrame& frame, const glm::dvec3& point) {
  const glm::dvec3 from = point - frame.corner, across = glm::normalize(glm::cross(frame.right, frame.down));
  return {glm::dot(from, frame.right) / glm::dot(frame.right, frame.right) * frame.width,
          glm::dot(from, frame.down) / glm::dot(frame.down, frame.down) * frame.height, glm::dot(from, across)};
}

/// Adds the line a -> b, in which a triangle meets the plane, to the rows that cross it; `side` tells the side of air.
void add_line(const glm::dvec2& a, const glm::dvec2& b, int side, Rows& rows) {
  const double low = std::min(a.y, b.y), high = std::max(a.y, b.y);
  const int first = std::max(0, static_cast<int>(std::ceil(std::max(low - 0.5, -1.0))));
  for (int row = first; row < std::ssize(rows) && row + 0.5 < high; ++row) {
    if (row + 0.5 < low) continue;
    const double share = (row + 0.5 - a.y) / (b.y - a.y);
    rows[static_cast<std::size_t>(row)].push_back({a.x + share * (b.x - a.x), side * (b.y > a.y ? 1 : -1)});
  }
}

Rows crossings_with(const DiffusionSurfaces& surfaces, const PictureFrame& frame) {
  std::vector<glm::dvec3> place;
  place.reserve(surfaces.vertex_count());
  for (const glm::vec3& p : surfaces.position) place.push_back(in_frame(frame, p));
  Rows rows(static_cast<std::size_t>(frame.height));
  for (std::size_t t = 0; t < surfaces.triangle_count(); ++t) {
    if (!surfaces.is_boundary(t)) continue;
    const glm::uvec3& corner = surfaces.triangle[t];
    std::array<glm::dvec2, 2> ends{};  // where the triangle's edge crosses the plane upwards, and downwards
    int found = 0;
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 &p = place[corner[k]], &q = place[corner[(k + 1) % 3]];
      if ((p.z < 0) == (q.z < 0)) continue;
      ends[p.z < 0 ? 0 : 1] = glm::dvec2(p) + (glm::dvec2(q) - glm::dvec2(p)) * (p.z / (p.z - q.z));
      ++found;
    }
    if (found == 2) add_line(ends[0], ends[1], surfaces.is_hidden(t, SideOf::front) ? 1 : -1, rows);
  }
  return rows;
}

/// The share of each pixel of a row that lies inside, exact along the row.
std::vector<double> inside_of(std::vector<RowCrossing> row, int width) {
  std::vector<double> share(static_cast<std::size_t>(width), 0.0);
  std::sort(row.begin(), row.end(), [](const RowCrossing& a, const RowCrossing& b) { return a.place < b.place; });
  int winding = 0;
  for (std::size_t i = 0; i + 1 < row.size(); ++i) {
    winding += row[i].turn;
    if (winding == 0) continue;
    const double from = std::clamp(row[i].place, 0.0, 1.0 * width), to = std::clamp(row[i + 1].place, 0.0, 1.0 * width);
    for (int x = static_cast<int>(from); x < width && x < to; ++x)
      share[static_cast<std::size_t>(x)] += std::max(0.0, std::min(to, x + 1.0) - std::max(from, 1.0 * x));
  }
  return share;
}

}  // namespace

std::vector<std::uint8_t> plane_picture(const DiffusionSurfaces& surfaces, const ColorField& field,
                                        const PictureFrame& frame) {
  const Rows rows = crossings_with(surfaces, frame);
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height) * 4);
  std::vector<std::size_t> inside;
  std::vector<glm::vec3> points;
  for (int y = 0; y < frame.height; ++y) {
    const std::vector<double> share = inside_of(rows[static_cast<std::size_t>(y)], frame.width);
    for (int x = 0; x < frame.width; ++x) {
      const double part = std::min(1.0, share[static_cast<std::size_t>(x)]);
      if (part < 0.02) continue;
      const auto pixel =
          4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) + static_cast<std::size_t>(x));
      pixels[pixel + 3] = static_cast<std::uint8_t>(std::lround(255 * part));
      inside.push_back(pixel);
      points.emplace_back(frame.corner + frame.right * ((x + 0.5) / frame.width) +
                          frame.down * ((y + 0.5) / frame.height));
    }
  }
  if (points.empty()) return pixels;
  const std::vector<Color> color = field.at(points).color;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const glm::u8vec3 srgb = to_srgb8(color[i]);
    for (int k = 0; k < 3; ++k) pixels[inside[i] + static_cast<std::size_t>(k)] = srgb[k];
  }
  return pixels;
}

}  // namespace pomona
