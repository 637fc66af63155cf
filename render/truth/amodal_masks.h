// Amodal masks: the pixels that each instance would cover if nothing hid it.
#pragma once

#include <vector>

#include "generator/base/parallel.h"
#include "generator/scene/scene.h"
#include "render/truth/mask.h"

namespace pomona {

/// Per instance, the pixels whose middle it lies behind, within the picture. A visible mask is always part of it: both
/// ask the same of the same triangles.
std::vector<Mask> amodal_masks(const Scene& scene, int width, int height, Threads threads = {});

}  // namespace pomona
