#include "render/export/collision/convex_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/mesh/principal_axes.h"
#include "render/export/collision/cut_surface.h"
#include "render/export/collision/hull_bulge.h"
#include "render/export/collision/hull_cut.h"
#include "render/export/collision/solid_bodies.h"

namespace pomona {

using namespace collision;

namespace {

/// A part while there may be cuts to come.
struct RoughPart {
  CutSurface surface;
  double excess = 0;  ///< cubic metres that its hull holds beyond it
  double side = 0;    ///< square metres: half its skin, such as the inner side of a wall
};

/// Directions all around, in the order of a grid on a cube.
std::vector<glm::dvec3> directions() {
  std::vector<glm::dvec3> list;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) list.emplace_back(x, y, z);
  return list;
}

/// The volume of the hull of some corners: those that stand out most along the directions, which its size follows
/// from, and some of all over the skin, without which the hull of a curved wall would be far too small.
double rough_hull_volume(const CutSurface& surface) {
  std::vector<glm::vec3> chosen;
  for (const glm::dvec3& along : directions()) {
    double farthest = -std::numeric_limits<double>::infinity();
    const glm::dvec3* at = nullptr;
    for (const Corners& triangle : surface.skin) {
      for (const glm::dvec3& p : triangle) {
        const double reach = glm::dot(p, along);
        if (reach > farthest) farthest = reach, at = &p;
      }
    }
    if (at) chosen.emplace_back(*at);
  }
  constexpr std::size_t some = 96;
  const std::size_t step = surface.skin.size() / some + 1;
  for (std::size_t t = 0; t < surface.skin.size(); t += step) chosen.emplace_back(surface.skin[t][t % 3]);
  for (const glm::dvec3& p : surface.cut_corners) chosen.emplace_back(p);
  return volume_of(convex_hull(chosen, chosen.size()));
}

RoughPart part_of(CutSurface surface) {
  RoughPart part;
  part.excess = rough_hull_volume(surface) - surface.volume();
  for (const Corners& c : surface.skin) part.side += glm::length(glm::cross(c[1] - c[0], c[2] - c[0])) / 4;
  part.surface = std::move(surface);
  return part;
}

/// The axes along which the skin reaches farthest and least.
std::array<glm::dvec3, 3> axes_of(const CutSurface& surface) {
  double area = 0;
  glm::dvec3 middle(0);
  glm::dmat3 spread(0);
  const auto share = [](const Corners& c) { return glm::length(glm::cross(c[1] - c[0], c[2] - c[0])); };
  const auto middle_of = [](const Corners& c) { return (c[0] + c[1] + c[2]) / 3.0; };
  for (const Corners& c : surface.skin) area += share(c), middle += share(c) * middle_of(c);
  if (area > 0) middle /= area;
  for (const Corners& c : surface.skin)
    spread += share(c) * glm::outerProduct(middle_of(c) - middle, middle_of(c) - middle);
  const glm::dmat3 turned(glm::mat3_cast(principal_axes(spread).rotation));
  return {turned[0], turned[1], turned[2]};
}

/// Planes across an axis, at shares of what the skin reaches along it.
void add_planes_across(std::vector<CuttingPlane>& planes, const CutSurface& surface, const glm::dvec3& axis,
                       std::initializer_list<double> shares) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Corners& triangle : surface.skin) {
    for (const glm::dvec3& p : triangle) {
      low = std::min(low, glm::dot(p, axis));
      high = std::max(high, glm::dot(p, axis));
    }
  }
  for (const double at : shares) planes.push_back({axis, low + at * (high - low)});
}

/// The planes that are tried: upright ones through the frame's axis, and some across the axes of the frame and the
/// part's own.
std::vector<CuttingPlane> planes_for(const CutSurface& surface) {
  std::vector<CuttingPlane> planes;
  constexpr int turns = 12;
  for (int k = 0; k < turns; ++k) {
    const double angle = pi * k / turns;
    planes.push_back({{reproducible::cos(angle), 0, reproducible::sin(angle)}, 0});
  }
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 normal(0);
    normal[axis] = 1;
    add_planes_across(planes, surface, normal, {0.5, 0.25, 0.75, 0.1, 0.9});
  }
  for (const glm::dvec3& axis : axes_of(surface)) add_planes_across(planes, surface, axis, {0.5, 0.25, 0.75});
  return planes;
}

/// The part cut where hulls hold the least; nothing if no plane goes through it.
std::optional<std::array<RoughPart, 2>> best_cut(const RoughPart& part) {
  std::optional<std::array<RoughPart, 2>> best;
  double least = std::numeric_limits<double>::infinity();
  const double volume = part.surface.volume();
  for (const CuttingPlane& plane : planes_for(part.surface)) {
    std::array<CutSurface, 2> sides = divided(part.surface, plane);
    if (sides[0].skin.empty() || sides[1].skin.empty()) continue;
    // Slivers do not help, though they cost little.
    const double share = sides[0].volume() / volume;
    if (volume > 0 && (share < 0.02 || share > 0.98)) continue;
    std::array<RoughPart, 2> parts{part_of(std::move(sides[0])), part_of(std::move(sides[1]))};
    const double price = (parts[0].excess + parts[1].excess + volume) * (1 + 0.02 * std::abs(share - 0.5));
    if (price < least) least = price, best = std::move(parts);
  }
  return best;
}

/// The hull without what stands out of the solid into its hollows: cut off by planes that touch the solid.
ConvexHull trimmed(ConvexHull hull, const CutSurface& surface, const ConvexPartsOptions& options) {
  std::vector<char> given_up(surface.skin.size(), 0);
  for (int trims = 0; trims < 24; ++trims) {
    const std::optional<Bulge> bulge = largest_bulge(hull, surface, options.overhang, given_up);
    if (!bulge) break;
    // A little before the surface: a plane that touches the hollow's deepest place takes of the walls around it.
    const CuttingPlane plane{bulge->plane.normal, bulge->plane.offset + 0.9 * options.overhang};
    ConvexHull less = behind(hull, plane, options.corners);
    // A wall that runs along the hull is no hollow: the plane would take the part itself.
    if (volume_of(less) < 0.6 * volume_of(hull)) {
      given_up[bulge->triangle] = 1;
      continue;
    }
    hull = std::move(less);
  }
  return hull;
}

}  // namespace

std::vector<ConvexHull> convex_parts(const Solid& solid, const ConvexPartsOptions& options) {
  std::vector<RoughPart> parts;
  for (CutSurface& body : bodies_of(solid)) parts.push_back(part_of(std::move(body)));
  std::vector<CutSurface> done;
  while (!parts.empty()) {
    const auto worst = std::max_element(parts.begin(), parts.end(),
                                        [](const RoughPart& a, const RoughPart& b) { return a.excess < b.excess; });
    const bool is_good = worst->excess <= options.layer * worst->side || parts.size() + done.size() >= options.most;
    std::optional<std::array<RoughPart, 2>> cut = is_good ? std::nullopt : best_cut(*worst);
    if (cut) {
      *worst = std::move((*cut)[0]);
      parts.push_back(std::move((*cut)[1]));
    } else {
      done.push_back(std::move(worst->surface));
      parts.erase(worst);
    }
  }
  std::vector<ConvexHull> hulls;
  for (const CutSurface& surface : done) {
    ConvexHull hull = trimmed(convex_hull(surface.points(), options.corners), surface, options);
    if (!hull.triangle.empty()) hulls.push_back(std::move(hull));
  }
  return hulls;
}

}  // namespace pomona
