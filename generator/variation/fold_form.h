// The properties that a blended curve must have by itself, whatever lies around it.
#pragma once

#include "generator/variation/fold_samples.h"

namespace pomona {

/// The properties that all drawn samples of a surface share: a blend must have them, too.
class FoldForm {
 public:
  explicit FoldForm(const FoldSamples& drawn);

  /// True if the curve, in the pie-shaped space, does not meet itself, stays between the fold lines (at least half as
  /// far from them as drawn), does not come near the axis, and, if closed, still runs counter-clockwise. True for an
  /// empty one.
  bool is_kept(const PolarCurve& fold) const;

 private:
  bool closed_ = false;
  bool simple_ = true;       ///< no sample meets itself
  double margin_ = 0;        ///< smallest distance from a fold line, as a share of the fold; closed loops only
  double least_radius_ = 0;  ///< metres
  double pie_ = 1;           ///< angle of the pie, radians
};

}  // namespace pomona
