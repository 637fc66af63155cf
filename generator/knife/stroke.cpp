#include "generator/knife/stroke.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/curve.h"

namespace pomona {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

glm::dvec2 right_of(const glm::dvec2& direction) { return {direction.y, -direction.x}; }

}  // namespace

double Stroke::Facet::along_of(const glm::dvec2& point) const { return glm::dot(point - start, direction); }

Stroke::Stroke(std::vector<glm::dvec2> points) {
  double along = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const glm::dvec2 way = points[i] - points[i - 1];
    const double length = glm::length(way);
    facets_.push_back(
        {points[i - 1], way / length, i == 1 ? -infinity : 0, i + 1 == points.size() ? infinity : length, along});
    along += length;
  }
}

Stroke::Place Stroke::nearest(const glm::dvec2& point) const {
  Place place;
  double best = infinity;               // squared distance
  glm::dvec2 best_way(0), outwards(0);  // direction from the nearest facet to the point, and to the right of the stroke
                                        // there
  for (std::size_t i = 0; i < facets_.size(); ++i) {
    const Facet& f = facets_[i];
    const double along = f.along_of(point);
    const glm::dvec2 way = point - f.start - std::clamp(along, f.from, f.to) * f.direction;
    const double square = glm::dot(way, way);
    if (square >= best) continue;
    best = square;
    best_way = way;
    place.facet = static_cast<int>(i);

    // At a corner the point is beside the end of an edge: the mean of both edges' right-hand sides tells its side.
    outwards = right_of(f.direction);
    if (along < f.from) outwards += right_of(facets_[i - 1].direction);
    if (along > f.to) outwards += right_of(facets_[i + 1].direction);
  }
  place.distance = std::copysign(std::sqrt(best), glm::dot(best_way, outwards));
  return place;
}

std::vector<glm::dvec2> cleaned(const std::vector<glm::dvec2>& points) {
  // Finds the distance that is too near.
  glm::dvec2 low(infinity), high(-infinity);
  for (const glm::dvec2& p : points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double min = 1e-4 * glm::length(high - low);

  // Leaves out points that are too near to the one before; the last point replaces one that it is too near to.
  std::vector<glm::dvec2> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!kept.empty() && glm::distance(kept.back(), points[i]) <= min) {
      if (i + 1 == points.size() && kept.size() > 1) kept.back() = points[i];
      continue;
    }
    kept.push_back(points[i]);
  }

  // Leaves out points where the line goes straight on.
  std::vector<glm::dvec2> bent;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (i > 0 && i + 1 < kept.size()) {
      const glm::dvec2 before = kept[i] - bent.back(), after = kept[i + 1] - kept[i];
      const double turn = before.x * after.y - before.y * after.x;
      if (std::fabs(turn) <= 1e-6 * glm::length(before) * glm::length(after) && glm::dot(before, after) > 0) continue;
    }
    bent.push_back(kept[i]);
  }
  return bent;
}

bool crosses_itself(const std::vector<glm::dvec2>& points, const glm::dvec2& middle, double reach) {
  // Lengthens both ends until they are out of reach, and checks whether that line is simple.
  Curve curve{points, false};
  const auto beyond = [&](const glm::dvec2& end, const glm::dvec2& before) {
    return end + (reach + glm::distance(end, middle)) * glm::normalize(end - before);
  };
  const std::size_t n = points.size();
  if (reach > 0) {
    curve.points.front() = beyond(points[0], points[1]);
    curve.points.back() = beyond(points[n - 1], points[n - 2]);
  }
  return !is_simple(curve);
}

}  // namespace pomona
