// A value that changes along a curve.
#pragma once

#include <algorithm>
#include <vector>

namespace pomona {

/// Piecewise linear values over [0, 1]; constant outside its stops, which ascend; never empty.
template <typename Value>
struct Ramp {
  struct Stop {
    double at = 0;
    Value value{};
  };
  std::vector<Stop> stops;

  static Ramp constant(const Value& value) { return {{{0.0, value}}}; }

  Value operator()(double t) const {
    if (t <= stops.front().at) return stops.front().value;
    const auto next = std::upper_bound(stops.begin(), stops.end(), t, [](double v, const Stop& s) { return v < s.at; });
    if (next == stops.end()) return stops.back().value;
    const Stop &a = *(next - 1), &b = *next;
    const auto share = static_cast<float>((t - a.at) / (b.at - a.at));
    return static_cast<Value>(a.value + (b.value - a.value) * share);
  }
};

}  // namespace pomona
