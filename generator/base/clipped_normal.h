// Random deviations of individuals.
#pragma once

#include <algorithm>

#include "generator/base/random.h"

namespace pomona {

constexpr double max_clipped_normal = 2;  // standard deviations

/// The n-th normal number of the stream, clamped, so that no individual is extreme.
inline double clipped_normal(const RandomStream& random, std::uint64_t n) {
  return std::clamp(random.normal(n), -max_clipped_normal, max_clipped_normal);
}

}  // namespace pomona
