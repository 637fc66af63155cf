// What is drawn in each fold, in a form in which folds can be blended (paper, section 4.2).
#pragma once

#include <vector>

#include "generator/template/template.h"
#include "generator/variation/polar_curve.h"

namespace pomona {

/// One surface in all folds of the drawing. A sample's azimuth is a share of its fold, 0 at one fold line and 1 at the
/// next: the paper's pie-shaped space, whatever its angle. All samples of a surface have equally many points, and
/// equal indices correspond: around the axis they run from fold line to fold line, loops within a fold
/// start where they lie nearest to each other.
struct FoldSamples {
  std::size_t surface = 0;       ///< index into Template::surfaces
  bool closed = false;           ///< a loop within the fold (Type II)
  std::vector<PolarCurve> fold;  ///< one per drawn fold; empty where the fold has no loop
};

/// The surfaces that change with the folds: loops around the axis that vary, and all loops within folds.
std::vector<FoldSamples> fold_samples(const Template& fruit);

/// Angles between the fold lines, radians; they add up to one turn.
std::vector<double> fold_widths(const FoldSymmetry& symmetry);

/// The shift s for which the sum of distances between a[i] and b[i + s] is least; the smallest if several are.
std::size_t best_shift(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b);

}  // namespace pomona
