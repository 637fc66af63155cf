// Shows that work of unknown length goes on.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "cli/deliver/progress.h"

namespace pomona {

/// While the object exists, a thread of its own shows how long the work has taken: on a terminal every second, in a log
/// every ten. It shows nothing in the first seconds, nor while `progress`, which must outlive it, reports countable
/// work. The thread mostly waits and does not affect results.
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
