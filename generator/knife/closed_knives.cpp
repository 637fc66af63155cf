#include "generator/knife/closed_knives.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include <glm/geometric.hpp>

#include "generator/knife/bite_marks.h"
#include "generator/knife/skin_offset.h"
#include "generator/knife/solid_of_revolution.h"

namespace pomona {

namespace {

/// Share of a knife's size by which its chords may stray from its circles, each way: 0.012 mm on a ball of 24 mm.
constexpr double roughness = 5e-4;

/// Where the level line that comes from the front (along z) and meets the axis at half the fruit's height enters the
/// skin. Where it meets none, the front of the fruit's bounds.
glm::dvec3 front_of(const DiffusionSurfaces& surfaces) {
  const Box<double> bounds = bounds_of(surfaces);
  const glm::dvec2 line(0, bounds.center().y);
  std::optional<double> front;
  for (std::size_t i = 0; i < surfaces.triangle_count(); ++i) {
    if (!surfaces.is_boundary(i)) continue;
    const glm::uvec3& t = surfaces.triangle[i];

    // Seen along the line, the line is a point. It lies in the triangle if the three triangles it makes with the edges
    // turn the same way; their areas are then the weights of the corners in the point where they meet.
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

/// Upright at the fruit's origin, unless the knife says where.
SolidPose pose_at(const std::optional<glm::dvec3>& at, const std::optional<glm::dvec3>& axis) {
  SolidPose pose;
  pose.at = at.value_or(pose.at);
  pose.axis = axis.value_or(pose.axis);
  pose.up = level_beside(pose.axis);
  return pose;
}

/// From the lowest to the highest vertex along the pose's axis, metres from its origin; 0 to 0 for no vertices.
std::pair<double, double> heights_along(const SolidPose& pose, const DiffusionSurfaces& surfaces) {
  double low = INFINITY, high = -INFINITY;
  for (const glm::uvec3& t : surfaces.triangle) {
    for (int i = 0; i < 3; ++i) {
      const double height = glm::dot(pose.axis, glm::dvec3(surfaces.position[t[i]]) - pose.at);
      low = std::min(low, height);
      high = std::max(high, height);
    }
  }
  if (!(low <= high)) return {0, 0};
  return {low, high};
}

/// Makes the surface of a closed knife; std::visit calls what fits its kind.
struct SurfaceMaker {
  const DiffusionSurfaces& surfaces;

  ClosedSurface operator()(const BallKnife& knife) const {
    const double tolerance = roughness * knife.diameter;
    const Curve outline = half_circle(0.5 * knife.diameter, tolerance);
    return posed(revolved(outline, {.tolerance = tolerance}), {.at = knife.at ? *knife.at : front_of(surfaces)});
  }

  /// It bites level towards the axis, the teeth above and below.
  ClosedSurface operator()(const BiteKnife& knife) const {
    // On the axis there is no level way to go, and it bites downwards.
    SolidPose pose;
    pose.at = knife.at ? *knife.at : front_of(surfaces);
    const glm::dvec3 inwards(-pose.at.x, 0, -pose.at.z);
    pose.axis = glm::length(inwards) > 1e-6 ? glm::normalize(inwards) : glm::dvec3(0, -1, 0);
    pose.up = glm::cross(pose.axis, level_beside(pose.axis));
    return posed(bite_marks(knife.width), pose);
  }

  /// A cylinder along the axis. It stands out of the fruit at the top, and at the bottom unless it has a depth.
  ClosedSurface operator()(const CoreKnife& knife) const {
    const SolidPose pose = pose_at(knife.at, knife.axis);
    const auto [low, high] = heights_along(pose, surfaces);
    const double beyond = 0.05 * (high - low) + knife.diameter, radius = 0.5 * knife.diameter;
    const bool through = !knife.depth || *knife.depth >= high - low;
    const Curve side{{{radius, through ? low - beyond : high - *knife.depth}, {radius, high + beyond}}, false};
    return posed(revolved(side, {.tolerance = roughness * knife.diameter}), pose);
  }

  ClosedSurface operator()(const RevolveKnife& knife) const {
    double widest = 0;
    for (const glm::dvec2& p : knife.profile.points) widest = std::max(widest, p.x);
    const RevolveOptions options{.tolerance = 2 * roughness * widest};
    return posed(revolved(knife.profile, options), pose_at(knife.at, knife.axis));
  }

  ClosedSurface operator()(const PeelKnife& knife) const {
    return peeled(surfaces, {.thickness = knife.thickness, .strip = knife.strip.value_or(0)});
  }

  ClosedSurface operator()(const SurfaceKnife& knife) const { return *knife.surface; }
};

}  // namespace

ClosedSurface surface_of(const ClosedCut& knife, const DiffusionSurfaces& surfaces) {
  return std::visit(SurfaceMaker{surfaces}, knife);
}

}  // namespace pomona
