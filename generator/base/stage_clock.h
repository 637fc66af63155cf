// The time that each stage took, for --stats.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "generator/base/stop_watch.h"

namespace pomona {

/// Times by the name of the stage, in the order of first use. Each thread has a clock of its own; clocks can be added.
class StageClock {
 public:
  /// Does the work and returns its result. Adds its time to the stage, even if it throws.
  template <typename Work>
  auto time(const std::string& stage, Work&& work) {
    const Running running{*this, stage, {}};
    return std::forward<Work>(work)();
  }

  void add(const std::string& stage, double milliseconds) {
    for (auto& [name, sum] : stages_) {
      if (name == stage) return void(sum += milliseconds);
    }
    stages_.emplace_back(stage, milliseconds);
  }
  void add(const StageClock& other) {
    for (const auto& [stage, milliseconds] : other.stages_) add(stage, milliseconds);
  }

  const std::vector<std::pair<std::string, double>>& stages() const { return stages_; }

 private:
  struct Running {
    StageClock& clock;
    const std::string& stage;
    StopWatch watch;
    ~Running() { clock.add(stage, watch.milliseconds()); }
  };
  std::vector<std::pair<std::string, double>> stages_;  // milliseconds
};

}  // namespace pomona
