// What a blended curve must keep by itself, whatever lies around it.
#pragma once

#include "generator/variation/fold_samples.h"

namespace pomona {

/// What all drawn samples of a surface have in common: a blend must have it too.
class FoldForm {
 public:
  explicit FoldForm(const FoldSamples& drawn);

  /// True if the curve, in the pie-shaped space, does not meet itself, stays between the fold lines (half as far from
  /// them as drawn), keeps clear of the axis, and, if closed, still runs counter-clockwise. Empty ones do.
  bool is_kept(const PolarCurve& fold) const;

 private:
  bool closed_ = false;
  bool simple_ = true;       ///< all samples are
  double margin_ = 0;        ///< least distance from a fold line, as a share of the fold; closed loops only
  double least_radius_ = 0;  ///< metres
  double pie_ = 1;           ///< angle of the pie, radians
};

}  // namespace pomona
