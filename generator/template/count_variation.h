// The variation of numbers: of folds, and of surfaces that not all individuals have.
#pragma once

#include <vector>

namespace pomona {

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
    double share = 1;  ///< of the folds, or of the fruits
  };

  std::vector<Folds> folds;  ///< the shares add up to 1; empty = as drawn
  std::vector<Presence> present;
};

}  // namespace pomona
