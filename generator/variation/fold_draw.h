// The random numbers behind each fold of a variant, and what each drawn fold counts for in it.
#pragma once

#include <vector>

#include "generator/base/random.h"

namespace pomona {

/// One fold to be made.
struct FoldDraw {
  /// How far it has stepped down towards the drawing: each rung below `mean_rung` takes a quarter off its distance from
  /// the samples' mean.
  static constexpr int mean_rung = 11, drawn_rung = 12;

  std::vector<double> z;   ///< a normal number for each drawn fold
  std::size_t source = 0;  ///< the drawn fold it takes its turn after
  double amount = 1;
  int rung = 0;
};

/// As many as there are to be folds, of a drawing with so many samples. Fold k draws from the purpose "vary/fold/k".
std::vector<FoldDraw> drawn_folds(std::size_t samples, VariantKey key, double amount, int folds);

/// What each sample counts for in the fold, clipped and stepped down; they add up to 1. Samples that are
/// not `present` count for nothing.
std::vector<double> coefficients(const FoldDraw& draw, const std::vector<bool>& present);

}  // namespace pomona
