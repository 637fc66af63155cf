// The drawn lines of a fruit.
#pragma once

#include "generator/base/color.h"

namespace pomona {

/// The ink of this fruit's lines.
struct InkStyle {
  Color color{0.03f, 0.02f, 0.015f};
  double width = 1.0;  ///< factor of the style's width
};

}  // namespace pomona
