// Ramps and painted sides as template files spell them.
#pragma once

#include <string>
#include <vector>

#include "generator/template/template.h"
#include "generator/template/toml_document.h"

namespace pomona {

/// A value, or stops [[0.0, value], [0.4, value], ...] that ascend within 0..1; `read` turns one TOML value into
/// one of the ramp.
template <typename Value, typename Read>
Ramp<Value> read_ramp(const TomlValue& value, const Value& fallback, Read read) {
  if (!value.is(TomlNode::Kind::array)) return Ramp<Value>::constant(value.given() ? read(value) : fallback);
  Ramp<Value> ramp;
  for (const TomlValue& stop : value.values()) {
    const std::vector<TomlValue> pair = stop.values();
    if (pair.size() != 2) {
      stop.error("is not a stop", "write [place, value] with a place from 0 to 1, as in [0.4, ...]");
      continue;
    }
    const double at = pair[0].number(0, {0, 1});
    if (!ramp.stops.empty() && at <= ramp.stops.back().at) pair[0].error("does not ascend", "sort the stops");
    ramp.stops.push_back({at, read(pair[1])});
  }
  if (value.values().empty()) value.error("has no stops", "write at least one, as in [[0.0, ...]]");
  return ramp.stops.empty() ? Ramp<Value>::constant(fallback) : ramp;
}

/// "#rrggbb", a ramp along, or { along = ..., around = ... }. `sample` and `stops` say where `pomona sketch --sample`
/// took the colours along; here they are only checked.
PaintedColor read_painted_color(const TomlValue& value);

/// { part = "skin", color = ..., hidden = true }.
Side read_side(const TomlTable& table, const std::vector<std::string>& parts);

}  // namespace pomona
