// How bright a colour is to the eye.
#pragma once

#include "generator/base/color.h"

namespace pomona {

/// Luminance of a linear colour (Rec. 709): 1 for white.
inline double luminance(const Color& color) {
  return 0.2126 * static_cast<double>(color.r) + 0.7152 * static_cast<double>(color.g) +
         0.0722 * static_cast<double>(color.b);
}

}  // namespace pomona
