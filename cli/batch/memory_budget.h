// How many items may be under way at once.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace pomona {

/// Memory as something that items borrow. Who finds too little left waits; who asks for more than there is gets it
/// once nobody else has any, so that all work ends.
class MemoryBudget {
 public:
  /// \param bytes 0 = no limit.
  explicit MemoryBudget(std::uint64_t bytes) : bytes_(bytes) {}

  /// What an item has borrowed, given back with this.
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
