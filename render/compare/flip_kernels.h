// The filters of FLIP [Andersson et al. 2020, sections 4.1.1 and 4.2.1], as one-dimensional factors.
#pragma once

#include <vector>

namespace pomona {

/// Weights at -radius ... radius.
using Kernel = std::vector<double>;

/// The contrast sensitivity of the eye, per opponent channel. A filter over the picture is a factor along rows times
/// the same along columns; that of blue and yellow is the sum of two such.
struct ContrastKernels {
  int radius = 0;
  Kernel light;
  Kernel red_green;
  Kernel blue_yellow_wide, blue_yellow_narrow;
};

/// Filters of edges and points: derivatives of a Gaussian across a smoothing Gaussian.
struct FeatureKernels {
  int radius = 0;
  Kernel smooth;
  Kernel edge;   ///< first derivative: positive weights sum to 1, negative ones to -1
  Kernel point;  ///< second derivative, likewise
};

ContrastKernels contrast_kernels(double pixels_per_degree);
FeatureKernels feature_kernels(double pixels_per_degree);

}  // namespace pomona
