// Progress of long work: a bar on a terminal, plain lines elsewhere, nothing with --quiet. On stderr, so that
// results on stdout stay clean.
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

  /// `done` of `total` items of `stage`, and about how long the rest will take. May be called from any thread.
  void report(const std::string& stage, std::size_t done, std::size_t total);

  /// The same with words of one's own after the bar; where there is no terminal, they are a line every ten seconds.
  void report_text(const std::string& stage, std::size_t done, std::size_t total, const std::string& text);

  /// That work of unknown length has gone on for so many milliseconds: from the third second on, and only if nothing
  /// has been reported of late. A line every ten seconds where there is no terminal.
  void report_waiting(const std::string& work, double so_far);

  /// A line of its own, such as a warning; never lost in the bar.
  void line(const std::string& text);

  /// The same for what is told even to those who want to hear of errors alone.
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
