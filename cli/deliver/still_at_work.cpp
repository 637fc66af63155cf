#include "cli/deliver/still_at_work.h"

#include <chrono>
#include <system_error>
#include <utility>

namespace pomona {

StillAtWork::StillAtWork(Progress& progress, std::string work) : progress_(progress), work_(std::move(work)) {
  try {
    teller_ = std::thread([this] { tell(); });
  } catch (const std::system_error&) {
    // Without a thread the work goes on without messages.
  }
}

StillAtWork::~StillAtWork() {
  if (!teller_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  ended_.notify_one();
  teller_.join();
}

void StillAtWork::tell() {
  constexpr std::chrono::seconds every(1);
  const StopWatch watch;
  std::unique_lock lock(mutex_);
  while (!ended_.wait_for(lock, every, [this] { return over_; })) progress_.report_waiting(work_, watch.milliseconds());
}

}  // namespace pomona
