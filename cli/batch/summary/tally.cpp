#include "cli/batch/summary/tally.h"

#include <cstdio>

namespace pomona {

namespace {

std::string formatted(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace

std::string duration_text(double seconds) {
  if (seconds < 100) return formatted("%.0f s", seconds);
  if (seconds < 6000) return formatted("%.0f min", seconds / 60);
  return formatted("%.1f h", seconds / 3600);
}

std::string progress_text(const Tally& tally) {
  std::string text = std::to_string(tally.done()) + "/" + std::to_string(tally.total) + ", " +
                     std::to_string(tally.failed) + " failed";
  const double rate = tally.per_second();
  if (rate <= 0) return text;
  return text + formatted(", %.1f a second, ", rate) +
         duration_text(static_cast<double>(tally.total - tally.done()) / rate) + " left";
}

}  // namespace pomona
