// Which part of the fruit each pixel of a scene's picture shows.
#pragma once

#include "generator/base/parallel.h"
#include "generator/scene/scene.h"
#include "render/plate/part_map.h"

namespace pomona {

/// Looked at in the middle of each pixel: the part of the vertex with the largest share in the foremost triangle. All
/// solids are taken to have the part names of the first.
PartMap scene_parts(const Scene& scene, int width, int height, Threads threads = {});

}  // namespace pomona
