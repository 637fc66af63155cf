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

/// From the nearest point of the facet.
glm::dvec2 way_from(const Stroke::Facet& f, const glm::dvec2& point) {
  return point - f.start - std::clamp(f.along_of(point), f.from, f.to) * f.direction;
}

/// The squared distance of a point from a box.
double square_from(const Stroke::Run& run, const glm::dvec2& point) {
  const glm::dvec2 way = glm::max(glm::max(run.low - point, point - run.high), glm::dvec2(0));
  return glm::dot(way, way);
}

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
  find_runs();
}

/// Leaves room for the rounding of distances.
void Stroke::find_runs() {
  glm::dvec2 low(infinity), high(-infinity);
  for (const Facet& f : facets_) low = glm::min(low, f.start), high = glm::max(high, f.start);
  const double room = 1e-9 * glm::length(high - low);
  for (std::size_t first = 0; first + 1 < facets_.size(); first += run_length) {
    Run run{facets_[first].start - room, facets_[first].start + room};
    for (std::size_t i = first; i < std::min(first + run_length, facets_.size() - 1); ++i) {
      run.low = glm::min(run.low, facets_[i + 1].start - room);
      run.high = glm::max(run.high, facets_[i + 1].start + room);
    }
    runs_.push_back(run);
  }
}

/// The first of the facets that are nearest.
std::size_t Stroke::nearest_facet(const glm::dvec2& point) const {
  double best = infinity;  // squared distance
  std::size_t nearest = 0;
  const auto see = [&](std::size_t i) {
    const glm::dvec2 way = way_from(facets_[i], point);
    const double square = glm::dot(way, way);
    if (square > best || (square == best && i >= nearest)) return;
    best = square;
    nearest = i;
  };
  const auto see_run = [&](std::size_t run) {
    for (std::size_t i = run * run_length; i < std::min((run + 1) * run_length, facets_.size() - 1); ++i) see(i);
  };

  // The endless ones, then the nearest run, then those that may hold something nearer.
  see(0);
  see(facets_.size() - 1);
  std::size_t nearest_run = 0;
  double least = infinity;
  for (std::size_t run = 0; run < runs_.size(); ++run) {
    const double square = square_from(runs_[run], point);
    if (square < least) least = square, nearest_run = run;
  }
  if (least > best) return nearest;
  see_run(nearest_run);
  for (std::size_t run = 0; run < runs_.size(); ++run)
    if (run != nearest_run && square_from(runs_[run], point) <= best) see_run(run);
  return nearest;
}

Stroke::Place Stroke::nearest(const glm::dvec2& point) const {
  const std::size_t nearest = nearest_facet(point);
  const Facet& f = facets_[nearest];
  const double along = f.along_of(point);
  const glm::dvec2 way = way_from(f, point);

  // At a corner the point is beside the end of an edge: the mean of both edges' right-hand sides tells its side.
  glm::dvec2 outwards = right_of(f.direction);
  if (along < f.from) outwards += right_of(facets_[nearest - 1].direction);
  if (along > f.to) outwards += right_of(facets_[nearest + 1].direction);
  return {std::copysign(std::sqrt(glm::dot(way, way)), glm::dot(way, outwards)), static_cast<int>(nearest)};
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
