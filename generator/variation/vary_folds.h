// Variants of N-fold templates: every fold is a blend of the drawn folds (paper, section 4.2, Figure 8 bottom).
#pragma once

#include <memory>
#include <vector>

#include "generator/base/random.h"
#include "generator/template/template.h"
#include "generator/variation/swept_check.h"

namespace pomona {

/// How one fold of a variant was made.
struct FoldReport {
  /// The number of steps towards the mean of the samples that were needed so that nothing crosses: 0 = none; 1 to 10 =
  /// each step reduces the distance by a quarter; 11 = the mean itself; 12 = a drawn fold.
  int rung = 0;
  bool sound = true;  ///< nothing crosses that does not cross in the drawing
};

struct FoldVariant {
  Template fruit;
  std::vector<FoldReport> folds;
};

/// An N-fold template that is prepared once and varied many times.
class FoldVariation {
 public:
  /// \throws Error (bad_data) if the drawing cannot be swept.
  explicit FoldVariation(const Template& fruit) : FoldVariation(fruit, SweptCheck(fruit)) {}

  /// \param swept the check of the drawing, if it exists already.
  FoldVariation(const Template& fruit, SweptCheck swept);

  /// All curves of a fold use the same weights, so that a chamber follows the wall around it. With an amount below 1, a
  /// fold is a mixture of the blend and a drawn fold (drawn folds are repeated in turn).
  /// \param drawn_counts whether folds have the same surfaces as the drawn ones, whatever the template says.
  FoldVariant draw(VariantKey key, double amount, int folds, bool drawn_counts = false) const;

 private:
  struct Prepared;
  std::shared_ptr<const Prepared> prepared_;
};

/// The template with the drawn folds repeated in turn.
Template repeat_folds(const Template& fruit, int folds);

}  // namespace pomona
