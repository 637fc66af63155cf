// Random deviations of individuals.
#pragma once

#include <algorithm>

#include "generator/base/random.h"

namespace pomona {

/// The n-th normal number of the stream, clamped to two standard deviations, so that no individual is extreme.
inline double clipped_normal(const RandomStream& random, std::uint64_t n) {
  return std::clamp(random.normal(n), -2.0, 2.0);
}

}  // namespace pomona
