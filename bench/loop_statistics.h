// Whether synthesised loops have the drawn loops' marginals and spectrum.
#pragma once

#include <array>
#include <vector>

#include "bench/variant_checks.h"

namespace pomona::bench {

/// Logarithms of radii over all azimuths, of all loops that are synthesised. Variances and powers are sums over the
/// loops, means over the variants.
struct LoopStatistics {
  double mean_shift =
      0;  ///< of the variants' means from the drawing's: the largest of any loop, in parts of the radius
  double least_deviation = 0, deviation = 0, most_deviation = 0;  ///< standard deviation over the drawn one
  /// Of harmonics 1 to 3, 4 to 15 and 16 to 63, in parts of the drawing's whole power.
  std::array<double, 3> drawn_power{}, power{};
};

LoopStatistics loop_statistics(const Template& fruit, const VariantSettings& settings);

}  // namespace pomona::bench
