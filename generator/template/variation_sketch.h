// The variation of a template beyond what the paper varies.
#pragma once

#include "generator/template/color_variation.h"
#include "generator/template/count_variation.h"

namespace pomona {

/// The random bend of the axes of variants, added to the drawn bend (axis_bend.h).
struct BendVariation {
  double angle = 0;     ///< standard deviation, radians
  double swing = 0;     ///< standard deviation, radians
  bool around = false;  ///< in all directions, not only along the drawn one
};

/// Everything is 0 if a template does not ask for it: then only curves vary, as in the paper (section 4.2).
struct VariationSketch {
  double size = 0;     ///< standard deviation of the logarithm of the size
  double profile = 0;  ///< standard deviation of the logarithm of height over width; other proportions follow
  BendVariation bend{};
  CountVariation counts{};
  ColorVariation color{};
};

}  // namespace pomona
