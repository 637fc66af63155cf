// A value that changes along a curve.
#pragma once

#include <cstddef>
#include <vector>

namespace pomona {

/// Piecewise linear values over [0, 1]; constant outside its stops; never empty.
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
    for (std::size_t i = 1; i < stops.size(); ++i) {
      const Stop& a = stops[i - 1];
      const Stop& b = stops[i];
      if (t < b.at) {
        const auto share = static_cast<float>((t - a.at) / (b.at - a.at));
        return static_cast<Value>(a.value + (b.value - a.value) * share);
      }
    }
    return stops.back().value;
  }
};

}  // namespace pomona
