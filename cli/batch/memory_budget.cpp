#include "cli/batch/memory_budget.h"

namespace pomona {

MemoryBudget::Loan::Loan(MemoryBudget& budget, std::uint64_t bytes) : budget_(budget), bytes_(bytes) {
  std::unique_lock lock(budget_.mutex_);
  budget_.given_back_.wait(
      lock, [this] { return budget_.bytes_ == 0 || budget_.lent_ == 0 || budget_.lent_ + bytes_ <= budget_.bytes_; });
  budget_.lent_ += bytes_;
}

MemoryBudget::Loan::~Loan() {
  {
    const std::lock_guard lock(budget_.mutex_);
    budget_.lent_ -= bytes_;
  }
  budget_.given_back_.notify_all();
}

}  // namespace pomona
