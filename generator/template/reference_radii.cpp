#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "generator/base/cross.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/template/template.h"

namespace pomona {

namespace {

glm::dvec2 direction(double azimuth) { return {reproducible::cos(azimuth), reproducible::sin(azimuth)}; }

/// The last crossing of the ray from the axis with the loop; 0 if there is none.
double radius_at(const Curve& loop, double azimuth) {
  const glm::dvec2 ray = direction(azimuth);
  double farthest = 0;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const glm::dvec2& a = loop.points[i];
    const glm::dvec2& b = loop.points[(i + 1) % loop.points.size()];
    const double side_a = cross(ray, a), side_b = cross(ray, b);
    if ((side_a <= 0) == (side_b <= 0)) continue;
    farthest = std::max(farthest, glm::dot(ray, a + (b - a) * (side_a / (side_a - side_b))));
  }
  return farthest;
}

/// The mean over the azimuth, not over the arc length.
double mean_radius(const Curve& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const glm::dvec2& a = loop.points[i];
    const glm::dvec2& b = loop.points[(i + 1) % loop.points.size()];
    sum += 0.5 * (glm::length(a) + glm::length(b)) * reproducible::atan2(cross(a, b), glm::dot(a, b));
  }
  return std::abs(sum) / (2 * pi);
}

ReferenceRadii extent(const Curve& loop) {
  ReferenceRadii radii{glm::length(loop.points.front()), 0};
  for (const glm::dvec2& p : loop.points) {
    radii.inner = std::min(radii.inner, glm::length(p));
    radii.outer = std::max(radii.outer, glm::length(p));
  }
  return radii;
}

/// How well the loop's middle points along the ray: the cosine of the angle between.
double alignment(const Curve& loop, const glm::dvec2& ray) {
  glm::dvec2 sum(0);
  for (const glm::dvec2& p : loop.points) sum += p;
  const double size = glm::length(sum);
  return size > 0 ? glm::dot(sum, ray) / size : -1;
}

ReferenceRadii in_fold_reference(const SurfaceSketch& surface) {
  // With an azimuth the one loop there counts, otherwise all of them.
  std::vector<const Curve*> loops;
  for (const Curve& loop : surface.horizontal) {
    if (!loop.points.empty()) loops.push_back(&loop);
  }
  if (loops.empty()) return {};
  if (surface.reference_azimuth) {
    const glm::dvec2 ray = direction(*surface.reference_azimuth);
    const auto less = [&](const Curve* a, const Curve* b) { return alignment(*a, ray) < alignment(*b, ray); };
    loops = {*std::max_element(loops.begin(), loops.end(), less)};
  }
  ReferenceRadii mean;
  for (const Curve* loop : loops) {
    mean.inner += extent(*loop).inner;
    mean.outer += extent(*loop).outer;
  }
  const auto count = static_cast<double>(loops.size());
  return {mean.inner / count, mean.outer / count};
}

}  // namespace

bool AxisOffset::is_zero() const {
  const auto is_nothing = [](const Ramp<double>& ramp) {
    return std::all_of(ramp.stops.begin(), ramp.stops.end(), [](const auto& stop) { return stop.value == 0; });
  };
  return is_nothing(x) && is_nothing(z);
}

ReferenceRadii reference_radii(const SurfaceSketch& surface) {
  if (surface.reference) return *surface.reference;
  if (surface.type == SurfaceType::in_fold) return in_fold_reference(surface);
  if (surface.horizontal.empty()) return {};
  const Curve& loop = surface.horizontal.front();
  return {0, surface.reference_azimuth ? radius_at(loop, *surface.reference_azimuth) : mean_radius(loop)};
}

}  // namespace pomona
