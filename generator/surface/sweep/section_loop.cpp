#include "generator/surface/sweep/section_loop.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include <glm/geometric.hpp>

#include "generator/base/cross.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona {

namespace {

/// The crossing of a loop with a ray from the axis.
struct RayCrossing {
  std::size_t edge = 0;
  double share = 0;  ///< share along the edge
  double radius = 0;
};

std::vector<RayCrossing> crossings(const Curve& loop, const glm::dvec2& ray) {
  std::vector<RayCrossing> found;
  const std::size_t n = loop.points.size();
  for (std::size_t e = 0; e < n; ++e) {
    const glm::dvec2 &a = loop.points[e], &b = loop.points[(e + 1) % n];
    const double before = cross(ray, a), after = cross(ray, b);
    if ((before < 0) == (after < 0)) continue;
    const double share = before / (before - after);
    const double radius = glm::dot(a + (b - a) * share, ray);
    if (radius > 0) found.push_back({e, share, radius});
  }
  return found;
}

std::optional<RayCrossing> farthest_crossing(const Curve& loop, const glm::dvec2& ray) {
  const std::vector<RayCrossing> all = crossings(loop, ray);
  const auto found = std::max_element(all.begin(), all.end(),
                                      [](const RayCrossing& l, const RayCrossing& r) { return l.radius < r.radius; });
  return found == all.end() ? std::nullopt : std::optional(*found);
}

/// The loop from one crossing on to the next (once around if they are the same), with both as its ends.
Curve between(const Curve& loop, const RayCrossing& from, const glm::dvec2& start, const RayCrossing& to,
              const glm::dvec2& end) {
  const std::size_t n = loop.points.size();
  const bool wraps = to.edge < from.edge || (to.edge == from.edge && to.share <= from.share);
  const std::size_t steps = (to.edge + (wraps ? n : 0)) - from.edge;
  Curve stretch{{start}, false};
  for (std::size_t k = 1; k <= steps; ++k) stretch.points.push_back(loop.points[(from.edge + k) % n]);
  stretch.points.push_back(end);
  return stretch;
}

void check(const Curve& loop) {
  const bool usable = loop.closed && loop.points.size() >= 3 && encloses(loop, glm::dvec2(0));
  if (!usable) {
    throw BadLoop("the horizontal curve does not surround the axis", "draw one closed curve around the axis");
  }
}

/// Appends all points but the last.
void append_spokes(SectionLoop& spokes, const Curve& even, double reference_radius, int fold) {
  const std::size_t steps = even.points.size() - 1;
  for (std::size_t i = 0; i < steps; ++i) {
    const double radius = glm::length(even.points[i]);
    spokes.direction.push_back(even.points[i] / radius);
    spokes.radius.push_back(radius / reference_radius);
    spokes.share.push_back(static_cast<double>(i) / static_cast<double>(steps));
    spokes.fold.push_back(fold);
  }
}

RayCrossing fold_crossing(const Curve& loop, std::size_t fold, double angle) {
  const std::vector<RayCrossing> all = crossings(loop, direction_of(angle));
  double nearest = all.front().radius, farthest = nearest;
  for (const RayCrossing& c : all) {
    nearest = std::min(nearest, c.radius);
    farthest = std::max(farthest, c.radius);
  }
  // Points on the fold line itself may, by rounding, cross it back and forth.
  if (farthest - nearest > 1e-6 * farthest) {
    throw BadLoop(
        "the horizontal curve crosses fold line " + std::to_string(fold) + " " + std::to_string(all.size()) + " times",
        "redraw the curve so that it crosses each fold line once, or move the fold line");
  }
  return all.front();
}

}  // namespace

glm::dvec2 direction_of(double angle) {
  const double quarters = std::round(angle / (pi / 2));
  if (std::fabs(angle - quarters * (pi / 2)) < 1e-12) {
    const double turn = quarters - 4 * std::floor(quarters / 4);
    return turn == 0   ? glm::dvec2(1, 0)
           : turn == 1 ? glm::dvec2(0, 1)
           : turn == 2 ? glm::dvec2(-1, 0)
                       : glm::dvec2(0, -1);
  }
  return {reproducible::cos(angle), reproducible::sin(angle)};
}

double angle_of(const glm::dvec2& point) { return reproducible::atan2(point.y, point.x); }

SectionLoop loop_at(const SectionStops& stops, double share) {
  const auto next = std::upper_bound(stops.at.begin(), stops.at.end(), share);
  if (next == stops.at.begin()) return stops.loop.front();
  if (next == stops.at.end()) return stops.loop.back();
  const auto after = static_cast<std::size_t>(next - stops.at.begin());
  const double t = (share - stops.at[after - 1]) / (stops.at[after] - stops.at[after - 1]);
  const double way = t * t * (3 - 2 * t);
  const SectionLoop& to = stops.loop[after];
  SectionLoop blend = stops.loop[after - 1];
  for (std::size_t i = 0; i < blend.radius.size(); ++i) {
    const double from = angle_of(blend.direction[i]), turn = angle_of(to.direction[i]) - from;
    blend.direction[i] = direction_of(from + way * (turn - 2 * pi * std::round(turn / (2 * pi))));
    blend.radius[i] += way * (to.radius[i] - blend.radius[i]);
  }
  return blend;
}

SectionLoop sampled_loop(const Curve& drawn, int count, double reference_radius) {
  check(drawn);
  const Curve loop = counter_clockwise(drawn);
  const std::optional<RayCrossing> start = farthest_crossing(loop, {1, 0});
  if (!start) throw BadLoop("the horizontal curve touches the axis", "draw it around the axis");
  const glm::dvec2 at(start->radius, 0);
  SectionLoop spokes;
  append_spokes(spokes, resampled(between(loop, *start, at, *start, at), count + 1), reference_radius, 0);
  return spokes;
}

SectionLoop sampled_folds(const Curve& drawn, std::span<const double> fold_angles, int count_per_fold,
                          double reference_radius) {
  check(drawn);
  const Curve loop = counter_clockwise(drawn);
  std::vector<RayCrossing> at;
  for (std::size_t k = 0; k < fold_angles.size(); ++k) at.push_back(fold_crossing(loop, k, fold_angles[k]));

  SectionLoop spokes;
  for (std::size_t k = 0; k < at.size(); ++k) {
    const std::size_t next = (k + 1) % at.size();
    const glm::dvec2 from = direction_of(fold_angles[k]) * at[k].radius;
    const glm::dvec2 to = direction_of(fold_angles[next]) * at[next].radius;
    const Curve stretch = between(loop, at[k], from, at[next], to);
    append_spokes(spokes, resampled(stretch, count_per_fold + 1), reference_radius, static_cast<int>(k));
  }
  return spokes;
}

}  // namespace pomona
