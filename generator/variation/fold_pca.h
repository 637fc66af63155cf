// Fold PCA: blending of fold samples by principal components (paper, section 4.2; [Blanz & Vetter 1999]).
#pragma once

#include <span>
#include <vector>

#include "generator/variation/polar_curve.h"

namespace pomona {

/// Weights w of x = mu + sum w_i (x_i - mu) from standard normal numbers z: w_i = (z_i - mean z) / sqrt(N - 1).
/// This is a draw from the principal component analysis (PCA) of the samples: x has mean mu and exactly their
/// covariance. The components themselves are not computed, so there is no choice of signs, and the bits are the same
/// everywhere.
std::vector<double> principal_weights(std::span<const double> z);

struct ClipOptions {
  double gain = 1;           ///< times the samples' standard deviation
  double extrapolation = 1;  ///< the coefficient of a sample is at least minus this; 0 = convex blends only
};

/// The weights times the gain, scaled down until they lie within the likeliest 95 % of draws and every coefficient
/// 1 / N + w_i is at least -extrapolation.
std::vector<double> clipped(std::vector<double> weights, const ClipOptions& options);

/// Point by point sum of coefficient times sample; empty samples must have coefficient 0.
PolarCurve blended(const std::vector<PolarCurve>& samples, std::span<const double> coefficients);

/// Joins curves that run from fold line to fold line, one per fold: neighbours meet on the lines. The radius of each
/// curve is scaled by a factor that changes linearly from line to line.
void join(std::vector<PolarCurve>& folds);

}  // namespace pomona
