// Pictures as linear light.
#pragma once

#include <vector>

#include "generator/base/color.h"
#include "render/image/image.h"

namespace pomona {

std::vector<Color> linear_pixels(const Image& picture);

/// The inverse; what is out of range is clamped.
Image image_of(const std::vector<Color>& pixels, int width, int height);

}  // namespace pomona
