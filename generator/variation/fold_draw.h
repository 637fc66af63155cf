// The random numbers of each fold of a variant, and the coefficients of the drawn folds in it.
#pragma once

#include <vector>

#include "generator/base/random.h"

namespace pomona {

/// One fold to be made.
struct FoldDraw {
  /// `rung` counts the steps towards the drawing. Each rung up to `mean_rung` reduces the distance from the samples'
  /// mean by a quarter; `mean_rung` is the mean, `drawn_rung` a drawn fold.
  static constexpr int mean_rung = 11, drawn_rung = 12;

  std::vector<double> z;   ///< a normal number for each drawn fold
  std::size_t source = 0;  ///< the drawn fold that it repeats
  double amount = 1;
  int rung = 0;
};

/// One draw for each of `folds` folds, of a drawing with `samples` folds. Fold k uses the random stream "vary/fold/k".
std::vector<FoldDraw> drawn_folds(std::size_t samples, VariantKey key, double amount, int folds);

/// The coefficient of each sample in the fold, after clipping and steps; their sum is 1. Samples that are not `present`
/// have coefficient 0.
std::vector<double> coefficients(const FoldDraw& draw, const std::vector<bool>& present);

}  // namespace pomona
