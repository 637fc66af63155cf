#include "render/truth/amodal_masks.h"

#include <algorithm>

#include "render/strokes/seen_solid.h"

namespace pomona {

namespace {

/// The pixels that an instance can cover at most.
PixelBox box_of(const Solid& solid, const SeenSolid& seen, int width, int height) {
  PixelBox box{width, height, -1, -1};
  for (std::uint32_t t = 0; t < solid.triangle.size(); ++t) {
    const PictureTriangle triangle = picture_triangle(solid, seen, t);
    if (!triangle.can_be_seen(solid.closed)) continue;
    const PixelSpan columns(triangle.low(0), triangle.high(0), 0, width - 1);
    const PixelSpan rows(triangle.low(1), triangle.high(1), 0, height - 1);
    if (columns.first > columns.last || rows.first > rows.last) continue;
    box = {std::min(box.left, columns.first), std::min(box.top, rows.first), std::max(box.right, columns.last),
           std::max(box.bottom, rows.last)};
  }
  return box;
}

Mask amodal_mask(const Solid& solid, const SeenSolid& seen, int width, int height) {
  Mask mask{box_of(solid, seen, width, height), {}};
  mask.covered.assign(static_cast<std::size_t>(mask.box.width()) * mask.box.height(), 0);
  for (std::uint32_t t = 0; t < solid.triangle.size(); ++t) {
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
