#include "generator/surface/file/far_from_origin.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pomona {

namespace {

/// The distance between neighbouring floats.
double step_at(double metres) { return metres * 0x1p-23; }

/// "448 km", "31 mm": three digits.
std::string length_text(double metres) {
  char text[32];
  const bool is_long = metres >= 1000, is_short = metres < 1;
  std::snprintf(text, sizeof text, "%.3g %s",
                is_long    ? metres / 1000
                : is_short ? metres * 1000
                           : metres,
                is_long    ? "km"
                : is_short ? "mm"
                           : "m");
  return text;
}

}  // namespace

double distance_of(const Box<double>& box) {
  double distance = 0;
  for (int k = 0; k < 3; ++k) distance = std::max({distance, std::fabs(box.low[k]), std::fabs(box.high[k])});
  return distance;
}

bool is_too_far(const Box<double>& box) {
  constexpr double max_change = 2e-4;
  return step_at(distance_of(box)) > max_change * glm::length(box.size());
}

std::string why_too_far(const Box<double>& box) {
  const double distance = distance_of(box);
  return "it lies " + length_text(distance) + " from the origin, where numbers have steps of " +
         length_text(step_at(distance));
}

std::string at_key(const Box<double>& box) {
  const glm::dvec3 middle = box.center();
  std::string text = "at = [";
  for (int k = 0; k < 3; ++k) {
    char number[40];
    std::snprintf(number, sizeof number, "%s\"%.2fm\"", k > 0 ? ", " : "", 0.0 - middle[k]);
    text += number;
  }
  return text + "]";
}

}  // namespace pomona
