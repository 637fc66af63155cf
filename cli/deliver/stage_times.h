// Times of the stages and counts, for --stats and the summary.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "generator/base/stage_clock.h"

namespace pomona {

class StageTimes {
 public:
  /// Runs `work` and adds its wall time to `stage`.
  template <typename Work>
  auto time(const std::string& stage, Work&& work) {
    return clock_.time(stage, std::forward<Work>(work));
  }
  void add(const std::string& stage, double milliseconds) { clock_.add(stage, milliseconds); }
  void add(const StageClock& clock) { clock_.add(clock); }
  void add(const StageTimes& more) {
    clock_.add(more.clock_);
    for (const auto& [what, number] : more.counts_) counts_[what] += number;
  }

  void count(const std::string& what, std::int64_t number) { counts_[what] += number; }

  /// Sets the diffuser that colours the faces, and its device (Diffuser::device). A command may have none.
  void diffused_by(const std::string& diffuser, const std::string& device);

  /// The JSON text of --stats (docs/reference/commands.md), indented, with a final newline.
  std::string json(int threads) const;

  /// "read 1 ms, sweep 12 ms, ..." in the order of the stages.
  std::string summary() const;

 private:
  StageClock clock_;
  std::map<std::string, std::int64_t> counts_;
  std::string diffuser_, device_;
};

}  // namespace pomona
