#include "render/strokes/identity_buffer.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "render/strokes/covered_pixels.h"

namespace pomona {

namespace {

constexpr int band_rows = 16;  // rows that one task draws

struct TriangleName {
  std::uint32_t instance = 0, triangle = 0;
};

/// The triangles of some of the instances, from `first` on, that touch each band of rows, in their order.
std::vector<std::vector<TriangleName>> sorted_into_bands(const Scene& scene, std::size_t first,
                                                         std::span<const SeenSolid> seen,
                                                         const IdentityBuffer& buffer) {
  std::vector<std::vector<TriangleName>> bands((buffer.height + band_rows - 1) / band_rows);
  const RasterSamples<double> all = pixel_middles({0, 0, buffer.width - 1, buffer.height - 1});
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const Solid& solid = scene.solids[scene.instances[first + i].solid];
    for (std::uint32_t t = 0; t < solid.mesh.triangle.size(); ++t) {
      const PictureTriangle triangle = picture_triangle(solid, seen[i], t);
      if (!triangle.can_be_seen(solid.closed)) continue;
      const PixelBox box = triangle.raster().box(all);
      if (box.empty()) continue;
      for (int band = box.top / band_rows; band <= box.bottom / band_rows; ++band)
        bands[band].push_back({static_cast<std::uint32_t>(first + i), t});
    }
  }
  return bands;
}

void draw_triangle(const PictureTriangle& t, const TriangleName& name, int top, int bottom, IdentityBuffer& buffer) {
  // The nearest triangle so far gives the pixel its identity.
  for_covered_pixels(t, {0, top, buffer.width - 1, std::min(bottom, buffer.height - 1)},
                     [&](int x, int y, double nearness_there) {
                       const auto nearness = static_cast<float>(nearness_there);
                       const std::size_t i = static_cast<std::size_t>(y) * buffer.width + x;
                       if (nearness <= buffer.nearness[i]) return;
                       buffer.nearness[i] = nearness;
                       buffer.instance[i] = name.instance + 1;
                       buffer.triangle[i] = name.triangle;
                     });
}

}  // namespace

std::size_t IdentityBuffer::pixel_at(const glm::dvec2& place) const {
  const auto index = [](double v, int size) { return static_cast<std::size_t>(std::clamp(v, 0.0, size - 1.0)); };
  return index(place.y, height) * width + index(place.x, width);
}

IdentityBuffer identity_buffer(const Scene& scene, const Lens& lens, Threads threads) {
  IdentityBuffer buffer{lens.width(), lens.height(), {}, {}, {}};
  buffer.nearness.assign(static_cast<std::size_t>(buffer.width) * buffer.height, 0.0f);
  buffer.instance.assign(buffer.nearness.size(), 0);
  buffer.triangle.assign(buffer.nearness.size(), 0);
  visit_seen_solids(scene, lens, threads, [&](std::size_t first, std::span<const SeenSolid> seen) {
    const std::vector<std::vector<TriangleName>> bands = sorted_into_bands(scene, first, seen, buffer);
    parallel_for(bands.size(), threads, [&](std::size_t band) {
      const int top = static_cast<int>(band) * band_rows;
      for (const TriangleName& name : bands[band]) {
        const Solid& solid = scene.solids[scene.instances[name.instance].solid];
        const PictureTriangle triangle = picture_triangle(solid, seen[name.instance - first], name.triangle);
        draw_triangle(triangle, name, top, top + band_rows - 1, buffer);
      }
    });
  });
  return buffer;
}

}  // namespace pomona
