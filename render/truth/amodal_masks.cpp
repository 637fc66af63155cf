#include "render/truth/amodal_masks.h"

#include <algorithm>

#include "render/strokes/seen_solid.h"

namespace pomona {

namespace {

/// The box of pixels that an instance can cover.
PixelBox box_of(const Solid& solid, const SeenSolid& seen, int width, int height) {
  PixelBox box{width, height, -1, -1};
  for (std::uint32_t t = 0; t < solid.mesh.triangle.size(); ++t) {
    const PictureTriangle triangle = picture_triangle(solid, seen, t);
    if (!triangle.can_be_seen(solid.closed)) continue;
    const PixelBox own = triangle.raster().box(pixel_middles({0, 0, width - 1, height - 1}));
    if (own.empty()) continue;
    box = {std::min(box.left, own.left), std::min(box.top, own.top), std::max(box.right, own.right),
           std::max(box.bottom, own.bottom)};
  }
  return box;
}

Mask amodal_mask(const Solid& solid, const SeenSolid& seen, int width, int height) {
  Mask mask{box_of(solid, seen, width, height), {}};
  mask.covered.assign(static_cast<std::size_t>(mask.box.width()) * mask.box.height(), 0);
  for (std::uint32_t t = 0; t < solid.mesh.triangle.size(); ++t) {
    const PictureTriangle triangle = picture_triangle(solid, seen, t);
    if (!triangle.can_be_seen(solid.closed)) continue;
    for_covered_pixels(triangle, mask.box, [&](int x, int y, double) {
      mask.covered[static_cast<std::size_t>(y - mask.box.top) * mask.box.width() + (x - mask.box.left)] = 1;
    });
  }
  return trimmed(mask);
}

}  // namespace

std::vector<Mask> amodal_masks(const Scene& scene, int width, int height, Threads threads) {
  const Lens lens(scene.view, width, height);
  std::vector<Mask> masks(scene.instances.size());
  parallel_for(masks.size(), threads, [&](std::size_t i) {
    const Instance& instance = scene.instances[i];
    const Solid& solid = scene.solids[static_cast<std::size_t>(instance.solid)];
    masks[i] = amodal_mask(solid, seen_solid(solid, instance.pose, lens), width, height);
  });
  return masks;
}

}  // namespace pomona
