// Hands things from those who make them ready to the one who waits for them.
#pragma once

#include <condition_variable>
#include <mutex>
#include <utility>
#include <vector>

namespace pomona {

template <typename Thing>
class ReadyQueue {
 public:
  void put(Thing thing) {
    const std::lock_guard lock(mutex_);
    ready_.push_back(std::move(thing));
    changed_.notify_one();
  }

  /// Says that nothing more will come.
  void close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    changed_.notify_one();
  }

  /// Waits for something, and takes all that is ready; nothing after the last.
  std::vector<Thing> take() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return closed_ || !ready_.empty(); });
    return std::exchange(ready_, {});
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Thing> ready_;
  bool closed_ = false;
};

}  // namespace pomona
