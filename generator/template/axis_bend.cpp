#include "generator/template/axis_bend.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pomona {

namespace {

/// A place within the line's table: the node below, and the share of the way to the next.
struct LinePlace {
  std::size_t node = 0;
  double share = 0;
};

LinePlace place_on(const std::vector<double>& line, double place) {
  const double stretches = static_cast<double>(line.size() - 1);
  const double at = std::clamp((place + 1) / 2, 0.0, 1.0) * stretches;
  const double node = std::min(std::floor(at), stretches - 1);
  return {static_cast<std::size_t>(node), at - node};
}

double slope(const std::vector<double>& line, std::size_t node) {
  return (line[node + 1] - line[node]) * static_cast<double>(line.size() - 1) / 2;
}

}  // namespace

bool AxisBend::twists() const {
  return std::any_of(twist.stops.begin(), twist.stops.end(), [](const auto& stop) { return stop.value != 0; });
}

// The first and the second Legendre polynomial: their mean is 0.
double AxisBend::lean(double place) const {
  const double bent = angle / 2 * place + swing / 3 * (1.5 * place * place - 0.5);
  if (line.empty()) return bent;
  const auto [node, share] = place_on(line, place);
  return bent + line[node] + share * (line[node + 1] - line[node]);
}

double AxisBend::turning(double place) const {
  const double bent = angle / 2 + swing * place;
  return line.empty() ? bent : bent + slope(line, place_on(line, place).node);
}

double AxisBend::largest_turning(double from, double to) const {
  double largest = std::max(std::fabs(turning(from)), std::fabs(turning(to)));
  if (line.empty()) return largest;
  // Between two nodes of the line the turning is a linear function, which is largest at one of them.
  const auto [low, high] = std::minmax(from, to);
  const std::size_t last = place_on(line, high).node;
  for (std::size_t node = place_on(line, low).node; node <= last; ++node) {
    const double begin = 2 * static_cast<double>(node) / static_cast<double>(line.size() - 1) - 1;
    const double end = begin + 2 / static_cast<double>(line.size() - 1);
    for (const double place : {std::max(begin, low), std::min(end, high)})
      largest = std::max(largest, std::fabs(angle / 2 + swing * place + slope(line, node)));
  }
  return largest;
}

AxisBend AxisBend::as_line() const {
  AxisBend drawn;
  if (!line.empty()) drawn.direction = direction;
  drawn.line = line;
  drawn.twist = twist;
  return drawn;
}

}  // namespace pomona
