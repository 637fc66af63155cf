// Times the stages of a cut for whoever looks on.
#pragma once

#include <string_view>
#include <utility>

#include "generator/base/stop_watch.h"
#include "generator/cut/cut_observer.h"

namespace pomona {

/// What `work` returns; the observer, if there is one, is told how long it took.
template <typename Work>
auto watched(CutObserver* observer, std::string_view stage, Work&& work) {
  const StopWatch watch;
  auto result = std::forward<Work>(work)();
  if (observer) observer->took(stage, watch.milliseconds());
  return result;
}

}  // namespace pomona
