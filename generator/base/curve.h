// Plane curves as polylines: what sketches become once they are read.
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace pomona {

/// A polyline in metres. A closed curve does not repeat its first point.
struct Curve {
  std::vector<glm::dvec2> points;
  bool closed = false;
};

double length(const Curve& curve);

/// The distance from a point to the segment from a to b, which may be equal.
double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b);

/// Enclosed area, positive for counter-clockwise closed curves.
double signed_area(const Curve& curve);

/// `count` points evenly spaced by arc length. Open: both ends included (count >= 2). Closed: the first
/// point is kept and the spacing is length / count (count >= 3).
Curve resampled(const Curve& curve, int count);

/// The point at arc length share t in [0, 1] (closed curves wrap).
glm::dvec2 point_at(const Curve& curve, double t);

/// The same closed curve, counter-clockwise.
Curve counter_clockwise(Curve curve);

/// True if no two edges of the curve meet but at shared ends. Exact up to the orientation test's rounding. A curve
/// so intricate that its edges overlap in x more than 2^24 times counts as not simple.
bool is_simple(const Curve& curve);

/// An open curve beside the axis x = 0, its ends joined to the axis by level edges unless they are on it.
Curve joined_to_axis(Curve curve);

/// True if the closed curve winds around the point.
bool encloses(const Curve& curve, const glm::dvec2& point);

}  // namespace pomona
