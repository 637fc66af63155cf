// The drawn lines of a fruit.
#pragma once

#include "generator/base/color.h"

namespace pomona {

/// How the ink runs on this fruit: the colour of its lines.
struct InkStyle {
  Color color{0.03f, 0.02f, 0.015f};
  double width = 1.0;  ///< times the style's
};

}  // namespace pomona
