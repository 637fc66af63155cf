#include "render/strokes/identity_buffer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pomona {

namespace {

constexpr int band_rows = 16;  // rows that one task draws

struct TriangleName {
  std::uint32_t instance = 0, triangle = 0;
};

struct SeenTriangle {
  std::array<glm::dvec3, 3> corner{};  // pixels, pixels, nearness
  double area = 0;                     // twice; above 0 where it faces the eye

  double low(int axis) const { return std::min({corner[0][axis], corner[1][axis], corner[2][axis]}); }
  double high(int axis) const { return std::max({corner[0][axis], corner[1][axis], corner[2][axis]}); }
};

SeenTriangle seen_triangle(const Solid& solid, const SeenSolid& seen, std::uint32_t t) {
  SeenTriangle result;
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3& v = seen.vertex[solid.triangle[t][i]];
    if (!(v.z > 0)) return {};  // behind the eye: left out
    result.corner[i] = {v.x, v.y, 1 / v.z};
  }
  const glm::dvec3 &a = result.corner[0], &b = result.corner[1], &c = result.corner[2];
  result.area = (c.x - a.x) * (b.y - a.y) - (b.x - a.x) * (c.y - a.y);
  return result;
}

/// First and last pixel whose centre lies in [low, high], within the picture.
struct PixelSpan {
  int first = 0, last = -1;
  PixelSpan(double low, double high, int size)
      : first(static_cast<int>(std::clamp(std::ceil(low - 0.5), 0.0, static_cast<double>(size)))),
        last(static_cast<int>(std::clamp(std::floor(high - 0.5), -1.0, size - 1.0))) {}
};

/// Which triangles touch which band of rows, in their order.
std::vector<std::vector<TriangleName>> sorted_into_bands(const Scene& scene, std::span<const SeenSolid> seen,
                                                         const IdentityBuffer& buffer) {
  std::vector<std::vector<TriangleName>> bands((buffer.height + band_rows - 1) / band_rows);
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const Solid& solid = scene.solids[scene.instances[i].solid];
    for (std::uint32_t t = 0; t < solid.triangle.size(); ++t) {
      const SeenTriangle triangle = seen_triangle(solid, seen[i], t);
      const bool hidden = solid.closed ? triangle.area <= 0 : triangle.area == 0;
      if (hidden) continue;
      const PixelSpan columns(triangle.low(0), triangle.high(0), buffer.width);
      const PixelSpan rows(triangle.low(1), triangle.high(1), buffer.height);
      if (columns.first > columns.last || rows.first > rows.last) continue;
      for (int band = rows.first / band_rows; band <= rows.last / band_rows; ++band) bands[band].push_back({i, t});
    }
  }
  return bands;
}

void draw_triangle(const SeenTriangle& t, const TriangleName& name, int top, int bottom, IdentityBuffer& buffer) {
  // The pixels of its box, and the way round it is seen.
  const PixelSpan columns(t.low(0), t.high(0), buffer.width);
  const PixelSpan rows(t.low(1), t.high(1), buffer.height);
  const double turn = t.area > 0 ? 1 : -1;
  for (int y = std::max(rows.first, top); y <= std::min(rows.last, bottom); ++y) {
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

      // Nearness is linear on the picture; what is nearer than all before it gives the pixel its name.
      const double sum = share[0] * t.corner[0].z + share[1] * t.corner[1].z + share[2] * t.corner[2].z;
      const auto nearness = static_cast<float>(sum / (turn * t.area));
      const std::size_t i = static_cast<std::size_t>(y) * buffer.width + x;
      if (nearness <= buffer.nearness[i]) continue;
      buffer.nearness[i] = nearness;
      buffer.instance[i] = name.instance + 1;
      buffer.triangle[i] = name.triangle;
    }
  }
}

}  // namespace

std::size_t IdentityBuffer::pixel_at(const glm::dvec2& place) const {
  const auto index = [](double v, int size) { return static_cast<std::size_t>(std::clamp(v, 0.0, size - 1.0)); };
  return index(place.y, height) * width + index(place.x, width);
}

IdentityBuffer identity_buffer(const Scene& scene, std::span<const SeenSolid> seen, const Lens& lens, Threads threads) {
  IdentityBuffer buffer{lens.width(), lens.height(), {}, {}, {}};
  buffer.nearness.assign(static_cast<std::size_t>(buffer.width) * buffer.height, 0.0f);
  buffer.instance.assign(buffer.nearness.size(), 0);
  buffer.triangle.assign(buffer.nearness.size(), 0);
  const std::vector<std::vector<TriangleName>> bands = sorted_into_bands(scene, seen, buffer);
  parallel_for(bands.size(), threads, [&](std::size_t band) {
    const int top = static_cast<int>(band) * band_rows;
    for (const TriangleName& name : bands[band]) {
      const Solid& solid = scene.solids[scene.instances[name.instance].solid];
      const SeenTriangle triangle = seen_triangle(solid, seen[name.instance], name.triangle);
      draw_triangle(triangle, name, top, top + band_rows - 1, buffer);
    }
  });
  return buffer;
}

}  // namespace pomona
