#include "generator/knife/solid_knives.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/units.h"
#include "generator/knife/skin_offset.h"
#include "generator/knife/solid_of_revolution.h"
#include "generator/surface/crossings.h"

namespace pomona {

namespace {

/// Share of a knife's size by which its chords may stray from its circles, each way: 0.012 mm on a ball of 24 mm.
constexpr double roughness = 5e-4;

/// Where a level line through the middle, at half height, meets the front of the skin: where its bounds do, if it meets
/// none.
glm::dvec3 front_of(const DiffusionSurfaces& surfaces) {
  const Box<double> bounds = bounds_of(surfaces);
  const glm::dvec2 line(0, bounds.center().y);
  std::optional<double> front;
  for (std::size_t i = 0; i < surfaces.triangle_count(); ++i) {
    if (!surfaces.is_boundary(i)) continue;
    const glm::uvec3& t = surfaces.triangle[i];
    const glm::dvec3 a(surfaces.position[t.x]), b(surfaces.position[t.y]), c(surfaces.position[t.z]);
    const auto area = [&](const glm::dvec3& p, const glm::dvec3& q) {
      return (p.x - line.x) * (q.y - line.y) - (p.y - line.y) * (q.x - line.x);
    };
    const double of_a = area(b, c), of_b = area(c, a), of_c = area(a, b), sum = of_a + of_b + of_c;
    const bool meets = (of_a >= 0 && of_b >= 0 && of_c >= 0) || (of_a <= 0 && of_b <= 0 && of_c <= 0);
    if (!meets || sum == 0) continue;
    const double z = (of_a * a.z + of_b * b.z + of_c * c.z) / sum;
    front = std::max(front.value_or(z), z);
  }
  return {line, front.value_or(bounds.high.z)};
}

ClosedSurface ball(const SolidShape& shape, const glm::dvec3& at) {
  const double tolerance = roughness * shape.size;
  return posed(revolved(half_circle(0.5 * shape.size, tolerance), {.tolerance = tolerance}), {.at = at});
}

/// A ball, not quite as high as wide, that bites level towards the axis; the teeth part in creases along its meridians.
ClosedSurface bite(const SolidShape& shape, const glm::dvec3& at) {
  constexpr double tooth = 8e-3;  // wide, metres: an incisor's
  const double tolerance = roughness * shape.size;
  RevolveOptions options;
  options.tolerance = tolerance;
  options.teeth = 4 * std::clamp(static_cast<int>(std::lround(0.25 * pi * shape.size / tooth)), 2, 16);
  SolidPose pose;
  pose.at = at;
  const glm::dvec3 inwards(-at.x, 0, -at.z);
  pose.axis = glm::length(inwards) > 1e-6 ? glm::normalize(inwards) : glm::dvec3(0, -1, 0);
  pose.up = glm::cross(level_beside(pose.axis), pose.axis);
  pose.height = 0.8;
  return posed(revolved(half_circle(0.5 * shape.size, tolerance), options), pose);
}

/// Upright at the fruit's origin, unless the knife says where.
SolidPose pose_of(const SolidShape& shape) {
  SolidPose pose;
  pose.at = shape.at.value_or(pose.at);
  pose.axis = shape.axis.value_or(pose.axis);
  pose.up = level_beside(pose.axis);
  return pose;
}

/// A cylinder along the axis that stands out of the fruit at the top, and at the bottom unless it has a depth.
ClosedSurface core(const SolidShape& shape, const DiffusionSurfaces& surfaces) {
  const SolidPose pose = pose_of(shape);
  double low = INFINITY, high = -INFINITY;
  for (const glm::uvec3& t : surfaces.triangle) {
    for (int i = 0; i < 3; ++i) {
      const double height = glm::dot(pose.axis, glm::dvec3(surfaces.position[t[i]]) - pose.at);
      low = std::min(low, height);
      high = std::max(high, height);
    }
  }
  if (!(low <= high)) low = high = 0;
  const double beyond = 0.05 * (high - low) + shape.size, radius = 0.5 * shape.size;
  const bool through = shape.depth == 0 || shape.depth >= high - low;
  const Curve side{{{radius, through ? low - beyond : high - shape.depth}, {radius, high + beyond}}, false};
  return posed(revolved(side, {.tolerance = roughness * shape.size}), pose);
}

ClosedSurface drawn(const Knife& knife) {
  const SolidShape& shape = knife.solid;
  double widest = 0;
  for (const glm::dvec2& p : shape.profile.points) widest = std::max(widest, p.x);
  return posed(revolved(shape.profile, {.tolerance = 2 * roughness * widest}), pose_of(shape));
}

}  // namespace

ClosedSurface knife_solid(const Knife& knife, const DiffusionSurfaces& surfaces) {
  const SolidShape& shape = knife.solid;
  switch (knife.kind) {
    case Knife::Kind::ball:
      return ball(shape, shape.at ? *shape.at : front_of(surfaces));
    case Knife::Kind::bite:
      return bite(shape, shape.at ? *shape.at : front_of(surfaces));
    case Knife::Kind::core:
      return core(shape, surfaces);
    case Knife::Kind::revolve:
      return drawn(knife);
    case Knife::Kind::peel:
      return peeled(surfaces, {.thickness = shape.size, .strip = shape.spiral});
    case Knife::Kind::surface:
      return *knife.surface;
    default:
      throw std::logic_error("knife \"" + knife.text + "\" has no closed surface");
  }
}

}  // namespace pomona
