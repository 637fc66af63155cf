// Fold PCA: blending of fold samples by principal components (paper, section 4.2; [Blanz & Vetter 1999]).
#pragma once

#include <span>
#include <vector>

#include "generator/variation/polar_curve.h"

namespace pomona {

/// Weights w of x = mu + sum w_i (x_i - mu) from standard normal numbers z: w_i = (z_i - mean z) / sqrt(N - 1).
/// x then has mean mu and exactly the covariance of the samples, as a draw along their principal
/// components has, without the components being found: no choice of signs, the same bits everywhere.
std::vector<double> principal_weights(std::span<const double> z);

struct ClipOptions {
  double gain = 1;           ///< times the samples' standard deviation
  double extrapolation = 1;  ///< no sample counts less than minus this; 0 = convex blends only
};

/// The weights times the gain, shrunk until they lie in the likeliest 95 % of draws and no sample counts less than
/// 1 / N + w_i = -extrapolation.
std::vector<double> clipped(std::vector<double> weights, const ClipOptions& options);

/// Point by point sum of coefficient times sample; empty samples must have coefficient 0.
PolarCurve blended(const std::vector<PolarCurve>& samples, std::span<const double> coefficients);

/// Makes curves that run from fold line to fold line, one per fold around the axis, meet on the lines: each is
/// scaled along its radius by a factor that goes linearly from line to line.
void join(std::vector<PolarCurve>& folds);

}  // namespace pomona
