// Tells that work of unknown length goes on.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "cli/deliver/progress.h"

namespace pomona {

/// While it lives, a thread of its own, which waits nearly all the time and has no part in results, says how long the
/// work has taken so far: on a terminal every second, in a log every ten. Nothing in the first seconds, nor while
/// `progress`, which lives longer, hears of work that can be counted.
class StillAtWork {
 public:
  StillAtWork(Progress& progress, std::string work);
  ~StillAtWork();
  StillAtWork(const StillAtWork&) = delete;
  StillAtWork& operator=(const StillAtWork&) = delete;

 private:
  void tell();

  Progress& progress_;
  std::string work_;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool over_ = false;
  std::thread teller_;  // the last member: it uses the others
};

}  // namespace pomona
