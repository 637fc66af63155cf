// Strokes laid over a picture.
#pragma once

#include <span>

#include "render/image/image.h"
#include "render/strokes/scene_strokes.h"

namespace pomona {

/// The picture with the strokes on it.
Image with_ink(Image picture, std::span<const SceneStroke> strokes);

}  // namespace pomona
