#include "generator/base/units.h"

#include <charconv>
#include <cmath>

namespace pomona {

std::optional<double> parse_number(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<double> parse_length(std::string_view text) {
  double scale = 1.0;
  if (text.ends_with("mm")) {
    scale = 1e-3;
    text.remove_suffix(2);
  } else if (text.ends_with("cm")) {
    scale = 1e-2;
    text.remove_suffix(2);
  } else if (text.ends_with("m")) {
    text.remove_suffix(1);
  }
  while (text.ends_with(" ")) text.remove_suffix(1);
  const std::optional<double> number = parse_number(text);
  if (!number) return std::nullopt;
  return *number * scale;
}

}  // namespace pomona
