// Whether the folds of variants are drawn with the statistics of the samples, and how much later steps change that.
#pragma once

#include <vector>

#include "bench/variant_checks.h"

namespace pomona::bench {

/// Over all folds of all variants and all curves that are blended. The error of the mean is relative to the samples'
/// standard deviation, that of the covariance to the samples' covariance (Frobenius norms).
struct FoldStatistics {
  double mean_error = 0, expected_mean_error = 0;  ///< of the unclipped draw; expected from chance alone
  double covariance_error = 0, expected_covariance_error = 0;
  /// Variance relative to the samples': of the unclipped draw; after clipping; after stepping down where something
  /// would have crossed; after joining along the fold lines.
  double unclipped = 0, clipped = 0, stepped = 0, joined = 0;
  double mean_shift = 0;  ///< shift of the final curves' mean, in the samples' standard deviation
};

FoldStatistics fold_statistics(const Template& fruit, const VariantSettings& settings,
                               const std::vector<VariantFacts>& variants);

}  // namespace pomona::bench
