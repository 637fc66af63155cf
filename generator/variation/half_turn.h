// The turn of a variant about its axis: which way it lies under the knife that halves it.
#pragma once

#include <vector>

#include "generator/template/template.h"
#include "generator/variation/fold_samples.h"
#include "generator/variation/polar_curve.h"

namespace pomona {

/// The drawing is turned by hand so that the plane z = 0 shows its chambers. A variant's fold lines stray by the sum of
/// its widths, and it may have another number of folds; so it is turned until that plane passes through what it passes
/// through in the drawing, as deep within as on both sides can be.
class HalfTurn {
 public:
  /// \param samples of the drawing.
  HalfTurn(const FoldSymmetry& drawn, const std::vector<FoldSamples>& samples);

  /// The angle by which all fold lines are to be turned, radians, at most a quarter turn to either side; 0 if the plane
  /// lies as well as in the drawing.
  /// \param folds for each of the samples, the curves of the variant's folds in the pie-shaped space.
  double operator()(const FoldSymmetry& variant, const std::vector<std::vector<PolarCurve>>& folds) const;

 private:
  /// How many sides of the axis show the chambers of one of the samples in the drawing.
  std::vector<int> shown_;
  double drawn_score_ = 0;
};

}  // namespace pomona
