// A vertical curve as the rings of a sweep: their positions, and their shares of the curve.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "generator/base/curve.h"

namespace pomona {

/// Points along a vertical curve (x = distance from the axis, y = height; metres).
struct Profile {
  std::vector<glm::dvec2> points;
  std::vector<double> share;  ///< arc length share of each point, 0..1
  bool closed = false;        ///< the last point is followed by the first
  bool starts_on_axis = false;
  bool ends_on_axis = false;
};

/// `count` points, evenly spaced between sharp corners, which are kept. Points within 1e-9 of the largest
/// radius are put on the axis.
Profile sampled_profile(const Curve& vertical, int count);

/// The integral of r^2 dy along the profile: positive if the front of its sweep, with rims closed by discs, is
/// outside as drawn.
double outward(const Profile& profile);

/// A closed vertical curve, divided at its bottom and its top into the arc near the axis and the arc away from it. Both
/// run upwards and are sampled at the same shares of their lengths (paper, section 4.1, Figure 7c).
struct ProfileArcs {
  std::vector<glm::dvec2> inner, outer;
  std::vector<double> share;
};

/// The samples are denser towards the ends, where a chamber is blunt.
ProfileArcs sampled_arcs(const Curve& closed_vertical, int count);

}  // namespace pomona
