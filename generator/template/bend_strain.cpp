#include "generator/template/bend_strain.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

/// The largest radius of the loops over the one that the vertical curve stands for.
double largest_swell(const SurfaceSketch& surface) {
  const double reference = reference_radii(surface).outer;
  double largest = reference;
  for (const Curve& loop : surface.horizontal) {
    for (const glm::dvec2& p : loop.points) largest = std::max(largest, glm::length(p));
  }
  return reference > 0 ? largest / reference : 1;
}

/// Half of what the directions of a drawn axis span.
double half_span(const AxisBend& bend) {
  constexpr int samples = 256;
  double low = bend.lean(-1), high = low;
  for (int i = 1; i <= samples; ++i) {
    const double lean = bend.lean(2.0 * i / samples - 1);
    low = std::min(low, lean);
    high = std::max(high, lean);
  }
  return 0.5 * (high - low);
}

double largest_lean(const AxisBend& bend) {
  if (!bend.line.empty()) return half_span(bend);
  double largest = std::max(std::fabs(bend.lean(-1)), std::fabs(bend.lean(1)));
  // Between the ends it is largest where the axis turns back.
  if (bend.swing != 0) {
    largest = std::max(largest, std::fabs(bend.lean(std::clamp(-0.5 * bend.angle / bend.swing, -1.0, 1.0))));
  }
  return largest;
}

}  // namespace

BendStrain bend_strain(const Template& fruit) {
  const HeightRange range = drawn_heights(fruit);
  if (!fruit.bend.leans() || !(range.high > range.low)) return {};
  const double half = 0.5 * (range.high - range.low), middle = 0.5 * (range.high + range.low);
  const double half_length = half * fruit.proportions.height_factor();
  double pressing = 0;
  for (const SurfaceSketch& surface : fruit.surfaces) {
    const double swell = largest_swell(surface);
    double radius_before = 0, place_before = 0;
    bool is_first = true;
    for (const glm::dvec2& p : surface.vertical.points) {
      const double place = (p.y - middle) / half;
      const double radius = p.x * swell * fruit.proportions.radius_factor(place);
      const double moved = fruit.proportions.place(place);
      const double turning = fruit.bend.largest_turning(is_first ? moved : place_before, moved);
      // Between two points of the curve the radius is at most that at one of them.
      pressing = std::max(pressing, std::max(radius, radius_before) * turning / half_length);
      radius_before = radius;
      place_before = moved;
      is_first = false;
    }
  }
  return {pressing, largest_lean(fruit.bend)};
}

}  // namespace pomona
