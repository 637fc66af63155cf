// Whether synthesised loops have the drawn loops' marginals and spectrum.
#pragma once

#include <array>
#include <vector>

#include "generator/template/template.h"

namespace pomona::bench {

/// One synthesised loop: the logarithm of its radius, over the reference radius, at all azimuths.
struct LoopShape {
  double mean = 0, variance = 0;
  std::array<double, 3> power{};  ///< its variance in harmonics 1 to 3, 4 to 15 and 16 to 63
};

/// All loops that variants of a cylindrical template synthesise; empty for other templates.
std::vector<LoopShape> loop_shapes(const Template& fruit);

/// Over all loops. Variances and powers are sums over the loops, means over the variants.
struct LoopStatistics {
  double mean_shift = 0;  ///< the mean over the variants less the drawn one, of the loop where that is largest
  double min_deviation = 0, deviation = 0, max_deviation = 0;  ///< standard deviation over the drawn one
  std::array<double, 3> drawn_power{}, power{};                ///< in parts of the drawing's variance
};

LoopStatistics loop_statistics(const std::vector<LoopShape>& drawn,
                               const std::vector<std::vector<LoopShape>>& variants);

}  // namespace pomona::bench
