// Amodal masks: the pixels that each instance would cover if nothing hid it.
#pragma once

#include <vector>

#include "generator/base/parallel.h"
#include "generator/scene/scene.h"
#include "render/truth/mask.h"

namespace pomona {

/// Per instance, the pixels whose middles it covers, within the picture. A visible mask is always part of it, because
/// both use the same test of the same triangles.
std::vector<Mask> amodal_masks(const Scene& scene, int width, int height, Threads threads = {});

}  // namespace pomona
