// Curves about the axis in polar form, the form in which they are varied (paper, section 4.2).
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "generator/base/curve.h"

namespace pomona {

/// A curve as azimuth and radius of each point.
struct PolarCurve {
  std::vector<double> azimuth;  ///< radians, unwrapped: it never jumps by a whole turn
  std::vector<double> radius;   ///< metres

  std::size_t size() const { return radius.size(); }
};

glm::dvec2 polar_point(double azimuth, double radius);

/// The points in polar form. A point on the axis gets the azimuth of the point before.
PolarCurve to_polar(std::span<const glm::dvec2> points);

Curve from_polar(const PolarCurve& curve, bool closed);

/// True if the closed curve goes once around the axis, counter-clockwise, its azimuth growing at every step:
/// each ray from the axis meets it once. Such a curve is star-shaped, hence simple.
bool is_star_shaped(const Curve& loop);

/// The hit of a ray from the axis with a curve.
struct RayHit {
  std::size_t edge = 0;  ///< index of the edge
  double share = 0;      ///< position along the edge, 0..1
  double radius = 0;     ///< distance from the axis, metres; 0 if the ray hits nothing
};
RayHit outermost_hit(const Curve& curve, double azimuth);

/// The radius at which a ray from the axis leaves a loop around it for the last time. Fast for star-shaped loops.
class RadiusOf {
 public:
  explicit RadiusOf(const Curve& loop);
  double operator()(double azimuth) const;

 private:
  Curve loop_;
  std::vector<double> azimuth_;  ///< of the points of a star-shaped loop and of the first point again; else empty
};

/// The part of the closed curve from one hit to another, both included; the whole curve if they are equal.
std::vector<glm::dvec2> walk(const Curve& loop, const RayHit& from, const RayHit& to);

}  // namespace pomona
