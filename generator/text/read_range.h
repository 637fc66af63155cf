// Reads keys of scene files and data sets that take one value, or [lowest, highest] for random values.
#pragma once

#include <optional>
#include <vector>

#include "generator/text/toml_document.h"

namespace pomona {

/// The values of a key of this kind: one, or the two ends. None, and a noted error, for an array of another length.
std::vector<TomlValue> range_ends(const TomlValue& value);

/// A range whose ends `read` reads. Nothing where the key is not given; nothing, and a noted error, where it is no
/// range.
template <typename Range, typename Read>
std::optional<Range> read_range(const TomlValue& value, Read&& read) {
  const std::vector<TomlValue> ends = range_ends(value);
  if (ends.empty()) return {};
  const auto low = read(ends.front());
  const auto high = ends.size() == 1 ? low : read(ends.back());
  if (!(high < low)) return Range{low, high};
  value.error("is empty", "write the lower end first");
  return {};
}

/// A range of numbers within limits.
std::optional<Within> number_range(const TomlValue& value, const Within& within);

}  // namespace pomona
