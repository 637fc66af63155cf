// Measures the times of the stages of a cut for an observer.
#pragma once

#include <string_view>
#include <utility>

#include "generator/base/stop_watch.h"
#include "generator/cut/cut_observer.h"

namespace pomona {

/// Does the work and returns its result. Reports its time to the observer, if there is one.
template <typename Work>
auto watched(CutObserver* observer, std::string_view stage, Work&& work) {
  const StopWatch watch;
  auto result = std::forward<Work>(work)();
  if (observer) observer->took(stage, watch.milliseconds());
  return result;
}

}  // namespace pomona
