// How long each stage of the road took, and what was counted: --stats and the last lines people see.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace pomona {

class StageTimes {
 public:
  /// Runs `work` and adds its wall time to `stage`.
  template <typename Work>
  auto time(const std::string& stage, Work&& work) {
    const Timer timer(*this, stage);
    return std::forward<Work>(work)();
  }

  void add(const std::string& stage, double milliseconds);
  void count(const std::string& what, std::int64_t number) { counts_[what] += number; }

  /// Which diffuser colours the faces, and on what (Diffuser::device). A command without one names none.
  void diffused_by(const std::string& diffuser, const std::string& device);

  /// The JSON text of --stats (docs/commands.md), indented, with a final newline.
  std::string json(int threads) const;

  /// "read 1 ms, sweep 12 ms, ..." in the order of the road.
  std::string summary() const;

 private:
  struct Timer {
    Timer(StageTimes& all, std::string name) : times(all), stage(std::move(name)) {}
    ~Timer() {
      const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
      times.add(stage, elapsed.count());
    }
    StageTimes& times;
    std::string stage;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  };

  std::vector<std::pair<std::string, double>> milliseconds_;  ///< in order of first appearance
  std::map<std::string, std::int64_t> counts_;
  std::string diffuser_, device_;
};

}  // namespace pomona
