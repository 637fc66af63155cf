// How far the variants of a template stray in what the paper does not vary.
#pragma once

#include "generator/template/color_variation.h"
#include "generator/template/count_variation.h"

namespace pomona {

/// How far the axes of variants bend, besides what is drawn (axis_bend.h).
struct BendVariation {
  double angle = 0;     ///< standard deviation, radians
  double swing = 0;     ///< standard deviation, radians
  bool around = false;  ///< towards all sides, rather than only along the drawn direction
};

/// Everything is 0 where a template does not ask for it: only curves vary then, as in the paper (section 4.2).
struct VariationSketch {
  double size = 0;     ///< standard deviation of the logarithm of the size
  double profile = 0;  ///< standard deviation of the logarithm of height over width; other proportions follow
  BendVariation bend{};
  CountVariation counts{};
  ColorVariation color{};
};

}  // namespace pomona
