// The part of the fruit in each pixel of a scene's picture.
#pragma once

#include "generator/base/parallel.h"
#include "generator/scene/scene.h"
#include "render/plate/part_map.h"

namespace pomona {

/// The part at the middle of each pixel: that of the vertex with the largest barycentric coordinate in the nearest
/// triangle. All solids must have the part names of the first.
PartMap scene_parts(const Scene& scene, int width, int height, Threads threads = {});

}  // namespace pomona
