// Connections whose request has not arrived yet. One thread reads them all, so that clients that send slowly, or
// nothing, cannot block others, however many they are.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <list>
#include <mutex>
#include <string>
#include <thread>

#include "render/export/transaction/durable_file.h"

namespace pomona {

struct HeadLimits {
  std::size_t connections = 200;         ///< that wait at a time; beyond it the one that has waited longest is closed
  std::size_t bytes = 16384;             ///< of a head: a request and its headers
  std::chrono::milliseconds time{5000};  ///< for a whole head to arrive
};

class WaitingHeads {
 public:
  /// \param arrived is called, on the reading thread, for each connection whose head is complete, with the bytes read.
  /// Connections that take too long, send too much or end before are closed.
  WaitingHeads(const HeadLimits& limits, std::function<void(Descriptor, std::string)> arrived);
  ~WaitingHeads();
  WaitingHeads(const WaitingHeads&) = delete;
  WaitingHeads& operator=(const WaitingHeads&) = delete;

  /// May be called from any thread.
  void add(Descriptor socket);

 private:
  struct Head {
    Descriptor socket;
    std::string text = {};
    std::chrono::steady_clock::time_point end = {};
  };
  enum class Progress { waits, arrived, gone };

  void read_all();
  void wait_for_any();
  void take_in_new();
  Progress read_some(Head& head) const;

  HeadLimits limits_;
  std::function<void(Descriptor, std::string)> arrived_;
  std::list<Head> heads_;  ///< used by the reading thread; the one that has waited longest is first
  std::mutex mutex_;
  std::list<Head> new_;  ///< guarded by the mutex
  bool ended_ = false;   ///< guarded by the mutex
  Descriptor wake_;      ///< an eventfd: there are new ones, or it is the end
  std::thread reader_;
};

}  // namespace pomona
