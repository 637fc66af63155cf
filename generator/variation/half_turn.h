// The turn of a variant about its axis: which way it lies under the knife that halves it.
#pragma once

#include <vector>

#include "generator/template/template.h"
#include "generator/variation/fold_samples.h"
#include "generator/variation/fold_sectors.h"
#include "generator/variation/polar_curve.h"

namespace pomona {

/// The drawing is turned by hand so that the plane z = 0 shows its chambers. A variant's fold lines stray by the sum of
/// its widths, and it may have another number of folds; so it is turned until that plane passes through what it passes
/// through in the drawing, as deep within as on both sides can be.
class HalfTurn {
 public:
  /// \param samples of the drawing.
  HalfTurn(const Template& drawn, const std::vector<FoldSamples>& samples);

  /// The angle by which all fold lines are to be turned, radians, at most a quarter turn to either side; 0 if the plane
  /// lies as well as in the drawing.
  /// \param folds for each of the samples, the curves of the variant's folds in the pie-shaped space.
  double operator()(const FoldSymmetry& variant, const std::vector<std::vector<PolarCurve>>& folds) const;

 private:
  /// What it is the same to show: samples whose loops lie at one height, between the same parts.
  struct Kind {
    std::vector<std::size_t> samples;  ///< indices
    int shown = 0;                     ///< on how many sides of the axis the drawing shows one of the loops
  };

  std::vector<Kind> kinds_;
  int shown_between_folds_ = 0;  ///< without chambers, the plane stays between fold lines
  double drawn_score_ = 0;

  double score_at(const std::vector<Sectors>& kinds, const Sectors& between_folds, double azimuth) const;
};

}  // namespace pomona
