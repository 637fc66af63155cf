// Time by the clock and by the processor; medians, because machines are shared.
#pragma once

#include <functional>

namespace pomona::bench {

/// Milliseconds. `processor` sums all threads of this process.
struct Duration {
  double wall = 0;
  double processor = 0;
};

Duration time_of(const std::function<void()>& work);

/// The times of `runs` runs.
Duration median_time(int runs, const std::function<void()>& work);

/// The peak of this process's memory so far, in megabytes.
double peak_megabytes();

}  // namespace pomona::bench
