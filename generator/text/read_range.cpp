#include "generator/text/read_range.h"

#include <limits>

namespace pomona {

std::vector<TomlValue> range_ends(const TomlValue& value) {
  if (!value.given()) return {};
  if (!value.is(TomlNode::Kind::array)) return {value};
  std::vector<TomlValue> ends = value.values();
  if (ends.size() == 2) return ends;
  value.error("needs two values", "write [lowest, highest], or one value");
  return {};
}

std::optional<Within> number_range(const TomlValue& value, const Within& within) {
  // An end that is wrong, and noted, makes no range empty.
  constexpr double wrong = std::numeric_limits<double>::quiet_NaN();
  return read_range<Within>(value, [&](const TomlValue& end) { return end.number(wrong, within); });
}

}  // namespace pomona
