// Work in the background: one piece of work runs on another thread while its owner prepares the next.
#pragma once

#include <functional>
#include <future>

#include "generator/base/parallel.h"

namespace pomona {

/// Runs one piece of work after another, in the order in which they were begun, never two at once. So the result does
/// not depend on the number of threads.
class BackgroundWork {
 public:
  /// With one thread, begin() does the work itself.
  explicit BackgroundWork(Threads threads) : apart_(resolved(threads) > 1) {}

  /// Waits for the work begun before, then begins this work. If the work before has thrown an exception, rethrows it
  /// and begins nothing. All that the work refers to must live as long as this object.
  void begin(std::function<void()> work);

  /// Waits until the last work is done. Rethrows its exception.
  void finish();

 private:
  bool apart_;
  std::future<void> under_way_;  ///< its destructor waits for the work
};

}  // namespace pomona
