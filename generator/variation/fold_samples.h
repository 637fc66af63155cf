// The drawn curves of each fold, in a form in which folds can be blended (paper, section 4.2).
#pragma once

#include <vector>

#include "generator/template/template.h"
#include "generator/variation/polar_curve.h"

namespace pomona {

/// One surface, or one stop of a surface, in all folds of the drawing. The azimuth of a sample is a share of its fold,
/// 0 at one fold line and 1 at the next: the paper's pie-shaped space, whatever its angle. All samples of a surface
/// have the same number of points, and points with equal indices correspond: curves around the axis run from fold line
/// to fold line; loops inside a fold start where they are nearest to each other.
struct FoldSamples {
  std::size_t surface = 0;       ///< index into Template::surfaces
  std::size_t loop = 0;          ///< around the axis: which of its horizontal curves
  bool closed = false;           ///< a loop within the fold (Type II)
  std::vector<PolarCurve> fold;  ///< one per drawn fold; empty where the fold has no loop
};

/// The surfaces that change with the folds: loops around the axis that vary, and all loops within folds.
std::vector<FoldSamples> fold_samples(const Template& fruit);

/// Angles between the fold lines, radians; they add up to one turn.
std::vector<double> fold_widths(const FoldSymmetry& symmetry);

/// The shift s with the smallest sum of distances between a[i] and b[i + s]; the smallest s if several are equal.
std::size_t best_shift(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b);

}  // namespace pomona
