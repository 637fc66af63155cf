// Curves about the axis in polar form, the form in which they are varied (paper, section 4.2).
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "generator/base/curve.h"

namespace pomona {

/// Points by azimuth (radians, unwrapped: it never jumps by a whole turn) and radius (metres).
struct PolarCurve {
  std::vector<double> azimuth;
  std::vector<double> radius;

  std::size_t size() const { return radius.size(); }
};

glm::dvec2 polar_point(double azimuth, double radius);

/// The points one by one. Where one lies on the axis its azimuth is that of the point before.
PolarCurve to_polar(std::span<const glm::dvec2> points);

Curve from_polar(const PolarCurve& curve, bool closed);

/// True if the closed curve goes once around the axis, counter-clockwise, its azimuth growing at every step:
/// each ray from the axis meets it once. Such a curve is star-shaped, hence simple.
bool is_star_shaped(const Curve& loop);

/// Where the ray from the axis meets the curve.
struct RayHit {
  std::size_t edge = 0;
  double share = 0;   ///< along the edge
  double radius = 0;  ///< 0 if the ray meets nothing
};
RayHit outermost_hit(const Curve& curve, double azimuth);

/// Where rays from the axis leave a loop around it for good, looked up fast for star-shaped loops.
class RadiusOf {
 public:
  explicit RadiusOf(const Curve& loop);
  double operator()(double azimuth) const;

 private:
  Curve loop_;
  std::vector<double> azimuth_;  ///< of the points of a star-shaped loop and of the first point again; else empty
};

/// The closed curve walked from one hit to another, hits included; once around if they are the same.
std::vector<glm::dvec2> walk(const Curve& loop, const RayHit& from, const RayHit& to);

}  // namespace pomona
