// The progress of a batch, as text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace pomona {

struct Tally {
  std::int64_t total = 0;   ///< items of this run
  std::int64_t found = 0;   ///< existing items
  std::int64_t made = 0;    ///< by this run, including failed ones
  std::int64_t failed = 0;  ///< of the made ones
  double seconds = 0;       ///< since the run began

  std::int64_t done() const { return found + made; }
  double per_second() const { return seconds > 0 ? static_cast<double>(made) / seconds : 0; }
};

/// "120/500, 2 failed, 8.3 a second, 46 s left"
std::string progress_text(const Tally& tally);

/// "3 s", "4 min", "5.2 h"
std::string duration_text(double seconds);

}  // namespace pomona
