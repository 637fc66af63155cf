#include "generator/variation/profile_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "generator/base/reproducible.h"
#include "generator/variation/polar_curve.h"

namespace pomona {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// The share of the free range that variants use; the rest covers the facets of the sweep.
constexpr double used_share = 0.8;

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// True if the inner points of two segments meet at one point.
bool cross_properly(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
  const double abc = cross(b - a, c - a), abd = cross(b - a, d - a);
  const double cda = cross(d - c, a - c), cdb = cross(d - c, b - c);
  return abc * abd < 0 && cda * cdb < 0;
}

std::size_t edge_count(const Curve& curve) { return curve.points.size() - (curve.closed ? 0 : 1); }

const glm::dvec2& end_of(const Curve& curve, std::size_t edge) {
  return curve.points[(edge + 1) % curve.points.size()];
}

bool cross_as_drawn(const Curve& a, const Curve& b) {
  for (std::size_t i = 0; i < edge_count(a); ++i) {
    for (std::size_t j = 0; j < edge_count(b); ++j) {
      if (cross_properly(a.points[i], end_of(a, i), b.points[j], end_of(b, j))) return true;
    }
  }
  return false;
}

double farthest(const Curve& curve) {
  double most = 0;
  for (const glm::dvec2& p : curve.points) most = std::max(most, p.x);
  return most;
}

/// Calls body(x) for the radius of every point of the curve at this height.
template <typename Body>
void for_radii_at(const Curve& curve, double height, const Body& body) {
  for (std::size_t e = 0; e < edge_count(curve); ++e) {
    const glm::dvec2& a = curve.points[e];
    const glm::dvec2& b = end_of(curve, e);
    if (height < std::min(a.y, b.y) || height > std::max(a.y, b.y)) continue;
    if (a.y == b.y) {
      body(a.x);
      body(b.x);
    } else {
      body(a.x + (b.x - a.x) * ((height - a.y) / (b.y - a.y)));
    }
  }
}

}  // namespace

LogRange free_log_ratio(const Curve& a, const Curve& b) {
  if (a.points.size() < 2 || b.points.size() < 2 || cross_as_drawn(a, b)) return {-unbounded, unbounded};

  // The curves first touch where a corner of one meets the other, and corners only move along the radius.
  // On the axis nothing moves.
  const double axis = 1e-6 * std::max(farthest(a), farthest(b));
  double low = 0, high = unbounded;
  const auto touch_at = [&](double ratio) {
    if (ratio <= 1) low = std::max(low, ratio);
    if (ratio >= 1) high = std::min(high, ratio);
  };
  for (const glm::dvec2& p : a.points) {
    if (p.x > axis) for_radii_at(b, p.y, [&](double x) { touch_at(x / p.x); });
  }
  for (const glm::dvec2& p : b.points) {
    if (p.x > axis)
      for_radii_at(a, p.y, [&](double x) {
        if (x > axis) touch_at(p.x / x);
      });
  }
  return {low > 0 ? reproducible::log(low) : -unbounded, high < unbounded ? reproducible::log(high) : unbounded};
}

double area_to_axis(const Curve& vertical) {
  double twice = 0;
  for (std::size_t i = 0; i + 1 < vertical.points.size(); ++i) {
    const glm::dvec2& a = vertical.points[i];
    const glm::dvec2& b = vertical.points[i + 1];
    twice += (a.x + b.x) * (b.y - a.y);
  }
  return 0.5 * std::abs(twice);
}

std::vector<double> log_shape(const Curve& loop, double reference, const std::vector<double>& azimuths) {
  const RadiusOf radius_of(loop);
  std::vector<double> shape;
  for (const double azimuth : azimuths) {
    const double radius = radius_of(azimuth);
    shape.push_back(radius > 0 && reference > 0 ? reproducible::log(radius / reference) : 0);
  }
  return shape;
}

LogRange allowed_log_ratio(const SurfaceSketch& a, const SurfaceSketch& b, const std::vector<double>& shape_a,
                           const std::vector<double>& shape_b) {
  const LogRange free = free_log_ratio(a.vertical, b.vertical);
  LogRange allowed{used_share * free.low, used_share * free.high};
  for (std::size_t i = 0; i < shape_a.size(); ++i) {
    allowed.low = std::min(allowed.low, shape_a[i] - shape_b[i]);
    allowed.high = std::max(allowed.high, shape_a[i] - shape_b[i]);
  }
  return allowed;
}

}  // namespace pomona
