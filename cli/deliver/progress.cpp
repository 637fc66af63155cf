#include "cli/deliver/progress.h"

#include <unistd.h>

#include <cstdio>

#include "generator/base/printable.h"

namespace pomona {

Progress::Progress(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() { clear_bar(); }

void Progress::clear_bar() {
  if (bar_shown_) std::fputs("\r\033[K", stderr);
  bar_shown_ = false;
}

void Progress::report(const std::string& stage, std::size_t done, std::size_t total) {
  if (quiet_ || total == 0) return;
  const std::lock_guard lock(mutex_);
  last_report_ = since_start_.milliseconds();
  if (stage != last_stage_) {
    // In a log one line at the beginning of a stage is enough.
    if (!terminal_) std::fprintf(stderr, "%s (%zu)\n", stage.c_str(), total);
    last_stage_ = stage;
    stage_began_ = since_start_.milliseconds();
    done_before_ = done;
  }
  if (!terminal_) return;
  draw_bar(stage, done, total, std::to_string(done) + "/" + std::to_string(total) + time_left(done, total));
}

/// The time left, if each item takes as long as those of this stage so far; empty while this is not yet reliable.
std::string Progress::time_left(std::size_t done, std::size_t total) const {
  constexpr double too_early = 2e3;  // milliseconds
  const double passed = since_start_.milliseconds() - stage_began_;
  if (done <= done_before_ || done >= total || passed < too_early) return {};
  const double left = passed * static_cast<double>(total - done) / static_cast<double>(done - done_before_) / 1e3;
  char text[48];
  if (left < 90) {
    std::snprintf(text, sizeof text, ", %.0f s left", left);
  } else {
    std::snprintf(text, sizeof text, ", %.0f min left", left / 60);
  }
  return text;
}

void Progress::report_text(const std::string& stage, std::size_t done, std::size_t total, const std::string& text) {
  if (quiet_ || total == 0) return;
  const std::lock_guard lock(mutex_);
  last_report_ = since_start_.milliseconds();
  if (terminal_) return draw_bar(stage, done, total, text);
  if (is_time_for_a_line()) std::fprintf(stderr, "%s %s\n", stage.c_str(), text.c_str());
}

void Progress::report_waiting(const std::string& work, double so_far) {
  constexpr double patience = 3e3;  // milliseconds
  if (quiet_ || so_far < patience) return;
  const std::lock_guard lock(mutex_);
  if (last_report_ && since_start_.milliseconds() - *last_report_ < patience) return;
  if (terminal_) {
    std::fprintf(stderr, "\r\033[K%s, %.0f s so far", work.c_str(), so_far / 1e3);
    std::fflush(stderr);
    bar_shown_ = true;
  } else if (is_time_for_a_line()) {
    std::fprintf(stderr, "%s, %.0f s so far\n", work.c_str(), so_far / 1e3);
  }
}

/// True every ten seconds, for a log.
bool Progress::is_time_for_a_line() {
  constexpr double between_lines = 10e3;  // milliseconds
  const double now = since_start_.milliseconds();
  if (now - last_line_ < between_lines) return false;
  last_line_ = now;
  return true;
}

void Progress::draw_bar(const std::string& stage, std::size_t done, std::size_t total, const std::string& text) {
  constexpr std::size_t width = 30;
  const std::size_t filled = width * done / total;
  std::fprintf(stderr, "\r\033[K%-8s [%s%s] %s", stage.c_str(), std::string(filled, '=').c_str(),
               std::string(width - filled, ' ').c_str(), text.c_str());
  std::fflush(stderr);
  bar_shown_ = true;
}

void Progress::line(const std::string& text) {
  if (!quiet_) error(text);
}

void Progress::error(const std::string& text) {
  const std::lock_guard lock(mutex_);
  clear_bar();
  std::fprintf(stderr, "%s\n", printable_line(text).c_str());
}

}  // namespace pomona
