// Variants of N-fold templates: every fold a blend of the drawn ones (paper, section 4.2, Figure 8 bottom).
#pragma once

#include <memory>
#include <vector>

#include "generator/base/random.h"
#include "generator/template/template.h"
#include "generator/variation/swept_check.h"

namespace pomona {

/// How one fold of a variant came about.
struct FoldReport {
  /// How often its blend was moved nearer to the mean of the samples because something would have crossed: 0 as
  /// drawn at random, up to 10 by a quarter each, 11 the mean itself, 12 a drawn fold.
  int rung = 0;
  bool sound = true;  ///< nothing crosses that does not in the drawing
};

struct FoldVariant {
  Template fruit;
  std::vector<FoldReport> folds;
};

/// An N-fold template made ready to be varied many times.
class FoldVariation {
 public:
  /// \throws Error (bad_data) if the drawing cannot be swept.
  explicit FoldVariation(const Template& fruit) : FoldVariation(fruit, SweptCheck(fruit)) {}

  /// `swept` is the drawing's, where that has been looked at before.
  FoldVariation(const Template& fruit, SweptCheck swept);

  /// One set of weights per fold serves everything in it, so that a chamber follows the wall around it. Below amount 1
  /// a fold is a mixture of the drawn one (in turn, if there are more or fewer folds than drawn) and the blend.
  /// \param drawn_counts whether folds have the same surfaces as the drawn ones, whatever the template says.
  FoldVariant draw(VariantKey key, double amount, int folds, bool drawn_counts = false) const;

 private:
  struct Prepared;
  std::shared_ptr<const Prepared> prepared_;
};

/// The drawn folds in turn.
Template repeat_folds(const Template& fruit, int folds);

}  // namespace pomona
