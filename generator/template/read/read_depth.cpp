#include "generator/template/read/read_depth.h"

#include "generator/template/read/read_stops.h"

namespace pomona {

namespace {

constexpr Within deep{0, 1};  // allowed depths below the skin, metres

}  // namespace

Ramp<double> read_depth_ramp(const TomlValue& value, double fallback, Within within) {
  if (!value.is(TomlNode::Kind::array)) return Ramp<double>::constant(value.number(fallback, within));
  const auto depth = [](const TomlValue& at) { return at.length(0, deep); };
  const auto number = [&](const TomlValue& stop) { return stop.number(fallback, within); };
  const Ramp<double> ramp{read_stops<double>(
      value, depth, number,
      {.one = "write [depth, value], as in [\"3mm\", ...]", .all = "write at least one, as in [[\"0mm\", ...]]"})};
  return ramp.stops.empty() ? Ramp<double>::constant(fallback) : ramp;
}

}  // namespace pomona
