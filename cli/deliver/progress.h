// Progress of long work on stderr: a bar on a terminal, plain lines elsewhere, nothing with --quiet.
#pragma once

#include <cstddef>
#include <mutex>
#include <optional>
#include <string>

#include "generator/base/stop_watch.h"

namespace pomona {

class Progress {
 public:
  explicit Progress(bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows `done` of `total` items of `stage`, and the estimated time left. May be called from any thread.
  void report(const std::string& stage, std::size_t done, std::size_t total);

  /// The same with another text after the bar; without a terminal, it is a line every ten seconds.
  void report_text(const std::string& stage, std::size_t done, std::size_t total, const std::string& text);

  /// Shows that work of unknown length has taken `so_far` milliseconds: from the third second on, and only without a
  /// recent report. Without a terminal, it is a line every ten seconds.
  void report_waiting(const std::string& work, double so_far);

  /// Prints a line of its own, such as a warning; the bar does not overwrite it.
  void line(const std::string& text);

  /// The same for errors, also with --quiet.
  void error(const std::string& text);

 private:
  void clear_bar();
  bool is_time_for_a_line();
  std::string time_left(std::size_t done, std::size_t total) const;
  void draw_bar(const std::string& stage, std::size_t done, std::size_t total, const std::string& text);

  std::mutex mutex_;
  bool quiet_;
  bool terminal_;
  bool bar_shown_ = false;
  std::string last_stage_;
  double stage_began_ = 0;       ///< milliseconds since the start,
  std::size_t done_before_ = 0;  ///< and how many items were done by then
  StopWatch since_start_;
  double last_line_ = 0;               ///< milliseconds since the start, of a line of what goes on
  std::optional<double> last_report_;  ///< the same, of work that can be counted
};

}  // namespace pomona
