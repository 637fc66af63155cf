// Pictures as linear light.
#pragma once

#include <vector>

#include "generator/base/color.h"
#include "render/image/image.h"

namespace pomona {

/// Light, row by row from the top left; 1 is white, and may be exceeded.
struct LinearImage {
  int width = 0, height = 0;
  std::vector<Color> pixels;
};

std::vector<Color> linear_pixels(const Image& picture);

/// The inverse; what is out of range is clamped.
Image image_of(const std::vector<Color>& pixels, int width, int height);

}  // namespace pomona
