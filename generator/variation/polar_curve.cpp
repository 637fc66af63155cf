#include "generator/variation/polar_curve.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "generator/base/cross.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona {

namespace {

std::size_t edge_count(const Curve& curve) {
  const std::size_t n = curve.points.size();
  return n < 2 ? 0 : (curve.closed ? n : n - 1);
}

/// Calls body(hit) for all hits of the ray in the order of the edges. An edge owns the side of the ray it starts
/// on, so that a curve through a vertex on the ray is met once.
template <typename Body>
void for_hits(const Curve& curve, double azimuth, const Body& body) {
  const glm::dvec2 ray = polar_point(azimuth, 1);
  const std::size_t n = curve.points.size();
  for (std::size_t e = 0; e < edge_count(curve); ++e) {
    const glm::dvec2& a = curve.points[e];
    const glm::dvec2& b = curve.points[e + 1 < n ? e + 1 : 0];
    const double side_a = cross(ray, a), side_b = cross(ray, b);
    if ((side_a < 0) == (side_b < 0)) continue;
    const double share = side_a / (side_a - side_b);
    const double radius = glm::dot(ray, a + (b - a) * share);
    if (radius > 0) body(RayHit{e, share, radius});
  }
}

}  // namespace

glm::dvec2 polar_point(double azimuth, double radius) {
  return {radius * reproducible::cos(azimuth), radius * reproducible::sin(azimuth)};
}

PolarCurve to_polar(std::span<const glm::dvec2> points) {
  PolarCurve curve;
  glm::dvec2 before(1, 0);
  double azimuth = 0;
  for (const glm::dvec2& p : points) {
    if (p != glm::dvec2(0)) {
      azimuth += reproducible::atan2(cross(before, p), glm::dot(before, p));
      before = p;
    }
    curve.azimuth.push_back(azimuth);
    curve.radius.push_back(glm::length(p));
  }
  return curve;
}

Curve from_polar(const PolarCurve& curve, bool closed) {
  Curve result;
  result.closed = closed;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    result.points.push_back(polar_point(curve.azimuth[i], curve.radius[i]));
  }
  return result;
}

bool is_star_shaped(const Curve& loop) {
  if (!loop.closed || loop.points.size() < 3) return false;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    if (!(cross(loop.points[i], loop.points[(i + 1) % loop.points.size()]) > 0)) return false;
  }
  // Even if the azimuth grows everywhere, the loop may go around more than once.
  int turns = 0;
  for_hits(loop, 0, [&](const RayHit&) { ++turns; });
  return turns == 1;
}

RayHit outermost_hit(const Curve& curve, double azimuth) {
  RayHit best;
  for_hits(curve, azimuth, [&](const RayHit& hit) {
    if (hit.radius > best.radius) best = hit;
  });
  return best;
}

RadiusOf::RadiusOf(const Curve& loop) : loop_(counter_clockwise(loop)) {
  if (!is_star_shaped(loop_)) return;
  azimuth_ = to_polar(loop_.points).azimuth;
  azimuth_.push_back(azimuth_.front() + 2 * pi);
}

double RadiusOf::operator()(double azimuth) const {
  if (azimuth_.empty()) return outermost_hit(loop_, azimuth).radius;

  // Find the edge, then where the ray meets the line through it.
  azimuth -= 2 * pi * std::floor((azimuth - azimuth_.front()) / (2 * pi));
  const auto after = std::upper_bound(azimuth_.begin() + 1, azimuth_.end() - 1, azimuth);
  const auto end = static_cast<std::size_t>(after - azimuth_.begin());
  const glm::dvec2& a = loop_.points[end - 1];
  const glm::dvec2& b = loop_.points[end % loop_.points.size()];
  const glm::dvec2 ray = polar_point(azimuth, 1);
  const double side_a = cross(ray, a), side_b = cross(ray, b);
  return glm::dot(ray, a + (b - a) * std::clamp(side_a / (side_a - side_b), 0.0, 1.0));
}

std::vector<glm::dvec2> walk(const Curve& loop, const RayHit& from, const RayHit& to) {
  const std::size_t n = loop.points.size();
  const auto at = [&](const RayHit& hit) {
    const glm::dvec2& a = loop.points[hit.edge];
    return a + (loop.points[(hit.edge + 1) % n] - a) * hit.share;
  };
  // If both hits are on one edge, the walk goes around the loop unless it only goes forward.
  std::size_t corners = (to.edge + n - from.edge) % n;
  if (corners == 0 && to.share <= from.share) corners = n;
  std::vector<glm::dvec2> points{at(from)};
  for (std::size_t i = 1; i <= corners; ++i) points.push_back(loop.points[(from.edge + i) % n]);
  points.push_back(at(to));
  return points;
}

}  // namespace pomona
