// Reads the stops of ramps in template files.
#pragma once

#include <string>
#include <vector>

#include "generator/template/ramp.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// Words for messages about a list of stops.
struct StopHints {
  std::string one;  ///< how a stop is written
  std::string all;  ///< how the list is
};

/// Reads [[place, value], ...] with ascending places; `read_at` reads a place, `read` a value.
template <typename Value, typename ReadAt, typename Read>
std::vector<typename Ramp<Value>::Stop> read_stops(const TomlValue& value, ReadAt read_at, Read read,
                                                   const StopHints& hints) {
  std::vector<typename Ramp<Value>::Stop> stops;
  const std::vector<TomlValue> listed = value.values();
  for (const TomlValue& stop : listed) {
    const std::vector<TomlValue> pair = stop.values();
    if (pair.size() != 2) {
      stop.error("is not a stop", hints.one);
      continue;
    }
    const double at = read_at(pair[0]);
    if (!stops.empty() && at <= stops.back().at) pair[0].error("does not ascend", "sort the stops");
    stops.push_back({at, read(pair[1])});
  }
  if (listed.empty() && value.is(TomlNode::Kind::array)) value.error("has no stops", hints.all);
  return stops;
}

/// Reads a value, or stops [[0.0, value], [0.4, value], ...] that ascend within 0..1; `read` reads one value of the
/// ramp.
template <typename Value, typename Read>
Ramp<Value> read_ramp(const TomlValue& value, const Value& fallback, Read read) {
  if (!value.is(TomlNode::Kind::array)) return Ramp<Value>::constant(value.given() ? read(value) : fallback);
  const auto place = [](const TomlValue& at) { return at.number(0, {0, 1}); };
  const Ramp<Value> ramp{read_stops<Value>(value, place, read,
                                           {.one = "write [place, value] with a place from 0 to 1, as in [0.4, ...]",
                                            .all = "write at least one, as in [[0.0, ...]]"})};
  return ramp.stops.empty() ? Ramp<Value>::constant(fallback) : ramp;
}

}  // namespace pomona
