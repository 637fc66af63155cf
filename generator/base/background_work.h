// One thing that is done while its owner goes on: what is made is handed on while the next is made.
#pragma once

#include <functional>
#include <future>

#include "generator/base/parallel.h"

namespace pomona {

/// One thing after another, in the order in which they were begun, and never two at once: so that what comes of them
/// does not depend on threads.
class BackgroundWork {
 public:
  /// With one thread everything is done when it is begun.
  explicit BackgroundWork(Threads threads) : apart_(resolved(threads) > 1) {}

  /// Waits for what was begun before, then begins this. Throws what that has thrown; this is not begun then. What the
  /// work refers to must live until this object does not.
  void begin(std::function<void()> work);

  /// Waits. Throws what the last work has thrown.
  void finish();

 private:
  bool apart_;
  std::future<void> under_way_;  ///< waits when it goes away
};

}  // namespace pomona
