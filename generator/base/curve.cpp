#include "generator/base/curve.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "generator/base/cross.h"

namespace pomona {

namespace {

std::size_t edge_count(const Curve& curve) {
  const std::size_t n = curve.points.size();
  return n < 2 ? 0 : (curve.closed ? n : n - 1);
}

const glm::dvec2& end_of(const Curve& curve, std::size_t edge) {
  return curve.points[(edge + 1) % curve.points.size()];
}

/// Arc length at the start of every edge, and the whole at the end.
std::vector<double> arc_lengths(const Curve& curve) {
  std::vector<double> at{0.0};
  for (std::size_t e = 0; e < edge_count(curve); ++e) {
    at.push_back(at.back() + glm::distance(curve.points[e], end_of(curve, e)));
  }
  return at;
}

glm::dvec2 point_at_length(const Curve& curve, const std::vector<double>& at, double s) {
  const auto after = std::upper_bound(at.begin(), at.end(), s);
  const auto last = static_cast<std::ptrdiff_t>(edge_count(curve)) - 1;
  const auto e = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after - at.begin() - 1, 0, last));
  const double span = at[e + 1] - at[e];
  const double share = span > 0 ? std::clamp((s - at[e]) / span, 0.0, 1.0) : 0.0;
  const glm::dvec2& a = curve.points[e];
  const glm::dvec2& b = end_of(curve, e);
  return share == 1.0 ? b : a + (b - a) * share;
}

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) { return cross(b - a, c - a); }

bool on_segment(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

/// Limit of the work of is_simple() on one curve: 256 overlaps in x for each of 65 536 edges, a tenth of a second.
constexpr std::size_t max_comparisons = std::size_t{1} << 24;

bool segments_meet(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
  const double abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
  if (((abc > 0) != (abd > 0)) && ((cda > 0) != (cdb > 0)) && abc != 0 && abd != 0 && cda != 0 && cdb != 0) return true;
  return (abc == 0 && on_segment(a, b, c)) || (abd == 0 && on_segment(a, b, d)) || (cda == 0 && on_segment(c, d, a)) ||
         (cdb == 0 && on_segment(c, d, b));
}

}  // namespace

namespace {

/// True if the path a, b, c runs back over itself.
bool turns_back(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return turn(a, b, c) == 0 && glm::dot(b - a, c - b) < 0;
}

/// True if an edge and the next one overlap.
bool has_spike(const Curve& curve) {
  const std::size_t n = curve.points.size();
  for (std::size_t i = curve.closed ? 0 : 1; i + (curve.closed ? 0 : 1) < n; ++i) {
    if (turns_back(curve.points[(i + n - 1) % n], curve.points[i], curve.points[(i + 1) % n])) return true;
  }
  return false;
}

}  // namespace

double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 ab = b - a;
  const double share = glm::dot(p - a, ab) / glm::dot(ab, ab);
  return glm::distance(p, a + ab * std::fmin(1, std::fmax(0, share)));
}

double length(const Curve& curve) { return arc_lengths(curve).back(); }

double signed_area(const Curve& curve) {
  double twice = 0;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    twice += cross(curve.points[i], curve.points[(i + 1) % curve.points.size()]);
  }
  return 0.5 * twice;
}

glm::dvec2 point_at(const Curve& curve, double t) {
  const std::vector<double> at = arc_lengths(curve);
  if (curve.closed) t -= std::floor(t);
  return point_at_length(curve, at, t * at.back());
}

Curve resampled(const Curve& curve, int count) {
  const std::vector<double> at = arc_lengths(curve);
  const int steps = curve.closed ? count : count - 1;
  Curve even;
  even.closed = curve.closed;
  for (int i = 0; i < count; ++i) even.points.push_back(point_at_length(curve, at, at.back() * i / steps));
  return even;
}

Curve counter_clockwise(Curve curve) {
  // Keep the first point first: ramps around a curve start there.
  if (signed_area(curve) < 0) std::reverse(curve.points.begin() + 1, curve.points.end());
  return curve;
}

bool is_simple(const Curve& curve) {
  if (has_spike(curve)) return false;

  // Sort edges by their left end and compare each with those that overlap it in x.
  struct Edge {
    glm::dvec2 a, b;
    std::size_t index;
  };
  std::vector<Edge> edges;
  for (std::size_t e = 0; e < edge_count(curve); ++e) edges.push_back({curve.points[e], end_of(curve, e), e});
  std::sort(edges.begin(), edges.end(), [](const Edge& l, const Edge& r) {
    const double lx = std::min(l.a.x, l.b.x), rx = std::min(r.a.x, r.b.x);
    return lx != rx ? lx < rx : l.index < r.index;
  });
  std::size_t comparisons_left = max_comparisons;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const double right = std::max(edges[i].a.x, edges[i].b.x);
    for (std::size_t j = i + 1; j < edges.size() && std::min(edges[j].a.x, edges[j].b.x) <= right; ++j) {
      if (comparisons_left-- == 0) return false;
      const std::size_t low = std::min(edges[i].index, edges[j].index);
      const std::size_t high = std::max(edges[i].index, edges[j].index);
      const bool neighbours = high == low + 1 || (curve.closed && low == 0 && high == edge_count(curve) - 1);
      if (!neighbours && segments_meet(edges[i].a, edges[i].b, edges[j].a, edges[j].b)) return false;
    }
  }
  return true;
}

Curve joined_to_axis(Curve curve) {
  if (curve.points.front().x > 0) curve.points.insert(curve.points.begin(), {0, curve.points.front().y});
  if (curve.points.back().x > 0) curve.points.emplace_back(0, curve.points.back().y);
  return curve;
}

bool encloses(const Curve& curve, const glm::dvec2& point) {
  int winding = 0;
  for (std::size_t e = 0; e < edge_count(curve); ++e) {
    const glm::dvec2& a = curve.points[e];
    const glm::dvec2& b = end_of(curve, e);
    if (a.y <= point.y && b.y > point.y && turn(a, b, point) > 0) ++winding;
    if (a.y > point.y && b.y <= point.y && turn(a, b, point) < 0) --winding;
  }
  return winding != 0;
}

}  // namespace pomona
