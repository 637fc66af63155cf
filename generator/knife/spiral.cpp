#include "generator/knife/spiral.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "generator/base/cross.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona {

namespace {

/// The convex outline to the right of the axis, bottom to top [Andrew 1979].
std::vector<glm::dvec2> convex_outline(std::vector<glm::dvec2> points) {
  std::sort(points.begin(), points.end(),
            [](const glm::dvec2& a, const glm::dvec2& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
  std::vector<glm::dvec2> hull{{0, points.front().y}};
  points.emplace_back(0, points.back().y);
  for (const glm::dvec2& p : points) {
    while (hull.size() > 1 && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0) hull.pop_back();
    if (p != hull.back()) hull.push_back(p);
  }
  return hull;
}

}  // namespace

OutlinePlace::OutlinePlace(const TriangleTree& skin) {
  // Turns all vertices into one half-plane about the axis.
  std::vector<glm::dvec2> points;
  double widest = 0;
  for (const TriangleTree::Corners& t : skin.triangles()) {
    for (const glm::dvec3& p : t) points.emplace_back(std::sqrt(p.x * p.x + p.z * p.z), p.y);
  }
  for (const glm::dvec2& p : points) widest = std::max(widest, p.x);
  outline_ = convex_outline(std::move(points));

  // The middle ends as far from either pole as the outline's largest distance from the axis, so that all parts of the
  // outline are seen from about as far. In a fruit that is at least as wide as high it is one point.
  const double middle = 0.5 * (outline_.front().y + outline_.back().y);
  low_middle_ = std::min(middle, outline_.front().y + widest);
  high_middle_ = std::max(middle, outline_.back().y - widest);

  along_.push_back(0);
  for (std::size_t i = 1; i < outline_.size(); ++i) {
    along_.push_back(along_.back() + glm::distance(outline_[i - 1], outline_[i]));
  }
}

double OutlinePlace::along(const glm::dvec3& point) const {
  const glm::dvec2 from(0, std::clamp(point.y, low_middle_, high_middle_));
  const glm::dvec2 way = glm::dvec2(std::sqrt(point.x * point.x + point.z * point.z), point.y) - from;

  // The first point of the outline to the left of the ray; the ray meets the edge before it.
  const auto is_right = [&](const glm::dvec2& p) { return cross(way, p - from) < 0; };
  const auto after = std::partition_point(outline_.begin(), outline_.end(), is_right);
  if (after == outline_.begin()) return 0;
  if (after == outline_.end()) return length();
  const std::size_t i = static_cast<std::size_t>(after - outline_.begin());
  const double before = -cross(way, outline_[i - 1] - from), beyond = cross(way, outline_[i] - from);
  return along_[i - 1] + before / (before + beyond) * (along_[i] - along_[i - 1]);
}

double turns_from_ridge(double along, const glm::dvec3& point, double pitch) {
  const double turns = along / pitch - reproducible::atan2(-point.z, point.x) / (2 * pi);
  return turns - std::round(turns);
}

}  // namespace pomona
