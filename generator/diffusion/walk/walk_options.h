// How exact random walks are to be.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "generator/base/parallel.h"

namespace pomona {

struct WalkOptions {
  double standard_error = 1;  ///< to reach at each point: RMS over the linear channels, in 1/255; above 0
  std::uint64_t seed = 0;
  Threads threads = {};

  /// A point takes no more walks than this, whatever its standard error; but for the last two batches of twelve that
  /// each half of its walks has begun.
  std::uint32_t max_walks = 4'000'000;

  /// Called with the points done and all points, from any thread, if given.
  std::function<void(std::size_t done, std::size_t total)> progress = {};
};

}  // namespace pomona
