// How much a variation may change.
#pragma once

#include <optional>

namespace pomona {

struct VariationOptions {
  double amount = 1.0;            ///< 0 = as drawn up to a turn, 1 = natural, 2 = wild
  std::optional<int> folds = {};  ///< another number of folds than drawn, 1..64 (N-fold templates only)
  bool curves_only = false;       ///< vary the horizontal curves alone, as in the paper, whatever the template says
  bool drawn_counts = false;      ///< as many folds and surfaces as drawn, whatever the template says
};

}  // namespace pomona
