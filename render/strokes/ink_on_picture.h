// Strokes laid over a picture.
#pragma once

#include <span>

#include "generator/base/parallel.h"
#include "render/image/image.h"
#include "render/strokes/scene_strokes.h"

namespace pomona {

/// The picture with the strokes on it, the same for any number of threads.
Image with_ink(Image picture, std::span<const SceneStroke> strokes, Threads threads = {});

}  // namespace pomona
