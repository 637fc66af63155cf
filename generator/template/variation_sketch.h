// The variation of a template beyond what the paper varies.
#pragma once

#include <vector>

#include "generator/template/color_variation.h"

namespace pomona {

/// The random bend of the axes of variants, added to the drawn bend (axis_bend.h).
struct BendVariation {
  double angle = 0;     ///< standard deviation, radians
  double swing = 0;     ///< standard deviation, radians
  bool around = false;  ///< in all directions, not only along the drawn one
};

/// The random numbers of an individual's parts. If a template does not ask for it, variants have what is drawn, and the
/// same triangles.
struct CountVariation {
  /// A number of folds, and how often it is seen among individuals.
  struct Folds {
    int number = 1;
    double share = 1;
  };

  /// A surface that not all individuals have: within folds it is missing from some of them, around the axis from some
  /// fruits.
  struct Presence {
    int surface = 0;   ///< index into Template::surfaces
    double share = 1;  ///< share of the folds, or of the fruits
  };

  std::vector<Folds> folds;  ///< the shares add up to 1; empty = as drawn
  std::vector<Presence> present;
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
