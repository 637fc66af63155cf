// Progress of long work: a bar on a terminal, plain lines elsewhere, nothing with --quiet. On stderr, so that
// results on stdout stay clean.
#pragma once

#include <cstddef>
#include <mutex>
#include <string>

namespace pomona {

class Progress {
 public:
  explicit Progress(bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` of `total` items of `stage`. May be called from any thread.
  void report(const std::string& stage, std::size_t done, std::size_t total);

  /// A line of its own, such as a warning; never lost in the bar.
  void line(const std::string& text);

 private:
  void clear_bar();

  std::mutex mutex_;
  bool quiet_;
  bool terminal_;
  bool bar_shown_ = false;
  std::string last_stage_;
};

}  // namespace pomona
