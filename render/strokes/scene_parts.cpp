#include "render/strokes/scene_parts.h"

#include <algorithm>
#include <array>

#include "generator/base/cross.h"
#include "render/strokes/identity_buffer.h"

namespace pomona {

namespace {

/// The corner of a triangle with the largest share in a place on the picture.
std::uint32_t corner_at(const SeenSolid& seen, const glm::uvec3& triangle, const glm::dvec2& place) {
  std::array<double, 3> share{};
  for (int i = 0; i < 3; ++i) {
    const glm::dvec2 a = glm::dvec2(seen.vertex[triangle[(i + 1) % 3]]) - place;
    const glm::dvec2 b = glm::dvec2(seen.vertex[triangle[(i + 2) % 3]]) - place;
    share[static_cast<std::size_t>(i)] = cross(a, b);
  }
  const double whole = share[0] + share[1] + share[2];
  for (double& s : share) s *= whole;
  return triangle[static_cast<int>(std::max_element(share.begin(), share.end()) - share.begin())];
}

}  // namespace

PartMap scene_parts(const Scene& scene, int width, int height, Threads threads) {
  // Parts are numbered by the names of the first solid.
  PartMap map{width, height, std::vector<std::int32_t>(static_cast<std::size_t>(width) * height, -1), {}};
  if (scene.solids.empty()) return map;
  map.names = scene.solids[0].look->part_names;

  // Finds the nearest triangle at each pixel.
  const Lens lens(scene.view, width, height);
  std::vector<SeenSolid> seen(scene.instances.size());
  parallel_for(seen.size(), threads, [&](std::size_t i) {
    seen[i] = seen_solid(scene.solids[scene.instances[i].solid], scene.instances[i].pose, lens);
  });
  const IdentityBuffer foremost = identity_buffer(scene, lens, threads);

  // There, the part of the triangle's corner that has the largest share in the pixel's middle.
  parallel_for(static_cast<std::size_t>(height), threads, [&](std::size_t y) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x) {
      const std::size_t pixel = y * static_cast<std::size_t>(width) + x;
      if (foremost.instance[pixel] == 0) continue;
      const std::size_t i = foremost.instance[pixel] - 1;
      const Solid& solid = scene.solids[scene.instances[i].solid];
      const glm::dvec2 middle(static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5);
      const std::int32_t part =
          solid.mesh.part[corner_at(seen[i], solid.mesh.triangle[foremost.triangle[pixel]], middle)];
      if (part >= 0 && part < static_cast<std::int32_t>(map.names.size())) map.part[pixel] = part;
    }
  });
  return map;
}

}  // namespace pomona
