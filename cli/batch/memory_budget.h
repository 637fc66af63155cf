// Limits how many items are made at once by their memory.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace pomona {

/// Memory that items borrow. An item waits while too little is left. An item that needs more than the whole budget runs
/// alone, so that all work ends.
class MemoryBudget {
 public:
  /// \param bytes 0 = no limit.
  explicit MemoryBudget(std::uint64_t bytes) : bytes_(bytes) {}

  /// The memory that an item has borrowed; the destructor returns it.
  class Loan {
   public:
    Loan(MemoryBudget& budget, std::uint64_t bytes);
    ~Loan();
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;

   private:
    MemoryBudget& budget_;
    std::uint64_t bytes_;
  };

 private:
  std::mutex mutex_;
  std::condition_variable given_back_;
  std::uint64_t bytes_, lent_ = 0;
};

}  // namespace pomona
