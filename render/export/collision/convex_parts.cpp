#include "render/export/collision/convex_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/mesh/disjoint_sets.h"
#include "generator/mesh/weld.h"
#include "render/export/collision/cut_surface.h"

namespace pomona {

using namespace collision;

namespace {

/// A part while there may be cuts to come.
struct RoughPart {
  CutSurface surface;
  double volume = 0;
  double excess = 0;  ///< cubic metres that its hull holds beyond it
};

/// How many directions a rough hull is asked for: few to compare planes, more to know when a part is good.
enum class HullDirections { few, many };

/// HullDirections all around, in the order of a grid on a cube.
const std::vector<glm::vec3>& directions(HullDirections how_many) {
  const auto grid = [](int steps) {
    std::vector<glm::vec3> list;
    for (int x = -steps; x <= steps; ++x)
      for (int y = -steps; y <= steps; ++y)
        for (int z = -steps; z <= steps; ++z)
          if (std::max({std::abs(x), std::abs(y), std::abs(z)}) == steps) list.emplace_back(x, y, z);
    return list;
  };
  static const std::vector<glm::vec3> few = grid(1), many = grid(2);
  return how_many == HullDirections::few ? few : many;
}

/// The volume of the hull of the points that stand out most along the directions: nearly that of their hull, and soon
/// found.
double rough_hull_volume(const std::vector<glm::vec3>& points, HullDirections how_many) {
  std::vector<glm::vec3> chosen;
  for (const glm::vec3& along : directions(how_many)) {
    float farthest = -std::numeric_limits<float>::infinity();
    std::size_t at = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const float reach = glm::dot(points[i], along);
      if (reach > farthest) farthest = reach, at = i;
    }
    if (!points.empty()) chosen.push_back(points[at]);
  }
  return volume_of(convex_hull(chosen, 2 * chosen.size()));
}

double excess_of(const RoughPart& part, HullDirections how_many) {
  return rough_hull_volume(part.surface.points(), how_many) - part.volume;
}

RoughPart part_of(CutSurface surface) {
  RoughPart part{.surface = std::move(surface)};
  part.volume = part.surface.volume();
  part.excess = excess_of(part, HullDirections::many);
  return part;
}

/// The planes that are tried: upright ones through the frame's axis, and some across the part's box.
std::vector<CuttingPlane> planes_for(const CutSurface& surface) {
  std::vector<CuttingPlane> planes;
  constexpr int turns = 12;
  for (int k = 0; k < turns; ++k) {
    const double angle = pi * k / turns;
    planes.push_back({{reproducible::cos(angle), 0, reproducible::sin(angle)}, 0});
  }
  const Box<double> box = surface.box();
  for (const double share : {0.5, 0.25, 0.75, 0.1, 0.9}) {
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 normal(0);
      normal[axis] = 1;
      planes.push_back({normal, box.low[axis] + share * (box.high[axis] - box.low[axis])});
    }
  }
  return planes;
}

/// The part cut where hulls hold the least, as few directions tell; nothing if no plane goes through it.
std::optional<std::array<RoughPart, 2>> best_cut(const RoughPart& part) {
  std::optional<std::array<RoughPart, 2>> best;
  double least = std::numeric_limits<double>::infinity();
  for (const CuttingPlane& plane : planes_for(part.surface)) {
    std::array<CutSurface, 2> sides = divided(part.surface, plane);
    if (sides[0].skin.empty() || sides[1].skin.empty()) continue;
    std::array<RoughPart, 2> parts;
    for (std::size_t i = 0; i < 2; ++i) {
      parts[i].surface = std::move(sides[i]);
      parts[i].volume = parts[i].surface.volume();
    }
    // Slivers do not help, though they cost little.
    const double share = parts[0].volume / part.volume;
    if (part.volume > 0 && (share < 0.02 || share > 0.98)) continue;
    for (RoughPart& side : parts) side.excess = excess_of(side, HullDirections::few);
    const double price = (parts[0].excess + parts[1].excess + part.volume) * (1 + 0.02 * std::abs(share - 0.5));
    if (price < least) least = price, best = std::move(parts);
  }
  if (best)
    for (RoughPart& side : *best) side.excess = excess_of(side, HullDirections::many);
  return best;
}

/// A surface for each body; all in one where cavities are among them, or it is open.
std::vector<CutSurface> bodies_of(const Solid& solid) {
  const SolidMesh& mesh = solid.mesh;
  const auto corners = [&](std::size_t t) { return mesh.corners(t); };
  const std::vector<std::uint32_t> welded = weld(mesh.position);
  DisjointSets sets(mesh.position.size());
  for (const glm::uvec3& t : mesh.triangle)
    for (int k = 0; k < 3; ++k) sets.join(welded[t[k]], welded[t[(k + 1) % 3]]);
  std::vector<std::size_t> number(mesh.position.size(), mesh.position.size());
  std::vector<CutSurface> bodies;
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    std::size_t& body = number[sets.root(welded[mesh.triangle[t].x])];
    if (body == mesh.position.size()) body = bodies.size(), bodies.emplace_back();
    bodies[body].skin.push_back(corners(t));
  }
  const bool all_are_solid =
      std::all_of(bodies.begin(), bodies.end(), [](const CutSurface& body) { return body.volume() > 0; });
  if (all_are_solid && solid.closed) return bodies;
  CutSurface all;
  for (const CutSurface& body : bodies) all.skin.insert(all.skin.end(), body.skin.begin(), body.skin.end());
  return {all};
}

/// A face of a hull as a plane, its normal of length 1.
struct FacePlane {
  glm::dvec3 normal;
  double offset = 0;
};

std::vector<FacePlane> faces_of(const ConvexHull& hull) {
  std::vector<FacePlane> faces;
  for (const glm::uvec3& t : hull.triangle) {
    const glm::dvec3 a(hull.position[t.x]), b(hull.position[t.y]), c(hull.position[t.z]);
    const glm::dvec3 area = glm::cross(b - a, c - a);
    const double length = glm::length(area);
    if (length > 0) faces.push_back({area / length, glm::dot(area / length, a)});
  }
  return faces;
}

/// How far it is from a point within the hull to the outside along a direction; 0 for a point that is not within.
double way_out(const std::vector<FacePlane>& faces, const glm::dvec3& point, const glm::dvec3& along) {
  double way = std::numeric_limits<double>::infinity();
  for (const FacePlane& face : faces) {
    const double depth = face.offset - glm::dot(face.normal, point), rate = glm::dot(face.normal, along);
    if (depth <= 0) return 0;
    if (rate > 1e-9) way = std::min(way, depth / rate);
  }
  return way;
}

/// What of the hull lies behind the plane.
ConvexHull behind(const ConvexHull& hull, const CuttingPlane& plane, std::size_t corners) {
  const auto height = [&](const glm::vec3& p) { return glm::dot(plane.normal, glm::dvec3(p)) - plane.offset; };
  std::vector<glm::vec3> points;
  for (const glm::vec3& p : hull.position)
    if (height(p) <= 0) points.push_back(p);
  for (const glm::uvec3& t : hull.triangle) {
    for (int k = 0; k < 3; ++k) {
      const glm::vec3 a = hull.position[t[k]], b = hull.position[t[(k + 1) % 3]];
      const double from = height(a), to = height(b);
      if (from < 0 && to > 0) points.emplace_back(glm::dvec3(a) + from / (from - to) * glm::dvec3(b - a));
    }
  }
  return convex_hull(points, corners);
}

/// Where a hull stands out of the solid farthest, seen from the middle of a triangle: the plane there touches the
/// solid.
struct Bulge {
  double way = 0;  ///< metres
  std::size_t triangle = 0;
  CuttingPlane plane;
};

/// \param given_up triangles that are passed over; empty for none. \param least way that counts, metres.
std::optional<Bulge> largest_bulge(const ConvexHull& hull, const CutSurface& surface, double least,
                                   const std::vector<char>& given_up) {
  const std::vector<FacePlane> faces = faces_of(hull);
  std::optional<Bulge> largest;
  for (std::size_t t = 0; t < surface.skin.size(); ++t) {
    if (!given_up.empty() && given_up[t]) continue;
    const Corners& c = surface.skin[t];
    const glm::dvec3 area = glm::cross(c[1] - c[0], c[2] - c[0]), middle = (c[0] + c[1] + c[2]) / 3.0;
    const double length = glm::length(area);
    if (!(length > 0)) continue;
    const double way = way_out(faces, middle, area / length);
    if (way <= least || way == std::numeric_limits<double>::infinity()) continue;
    least = way;
    largest = Bulge{way, t, {area / length, glm::dot(area / length, middle)}};
  }
  return largest;
}

/// The hull without what stands out of the solid into its hollows: cut off by planes that touch the solid.
ConvexHull trimmed(ConvexHull hull, const CutSurface& surface, const ConvexPartsOptions& options) {
  std::vector<char> given_up(surface.skin.size(), 0);
  for (int trims = 0; trims < 24; ++trims) {
    const std::optional<Bulge> bulge = largest_bulge(hull, surface, options.overhang, given_up);
    if (!bulge) break;
    ConvexHull less = behind(hull, bulge->plane, options.corners);
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

double depth_in(const ConvexHull& hull, const glm::dvec3& point) {
  double depth = std::numeric_limits<double>::infinity();
  for (const FacePlane& face : faces_of(hull)) depth = std::min(depth, face.offset - glm::dot(face.normal, point));
  return hull.triangle.empty() ? -depth : depth;
}

double volume_of(const ConvexHull& hull) {
  if (hull.triangle.empty()) return 0;
  const glm::dvec3 middle(hull.position.front());
  double six_times = 0;
  for (const glm::uvec3& t : hull.triangle) {
    six_times += glm::dot(glm::dvec3(hull.position[t.x]) - middle,
                          glm::cross(glm::dvec3(hull.position[t.y]) - middle, glm::dvec3(hull.position[t.z]) - middle));
  }
  return six_times / 6;
}

std::vector<ConvexHull> convex_parts(const Solid& solid, const ConvexPartsOptions& options) {
  std::vector<RoughPart> parts;
  double whole = 0;
  for (CutSurface& body : bodies_of(solid)) {
    parts.push_back(part_of(std::move(body)));
    whole += std::abs(parts.back().volume);
  }
  std::vector<RoughPart> done;
  while (!parts.empty()) {
    const auto worst = std::max_element(parts.begin(), parts.end(),
                                        [](const RoughPart& a, const RoughPart& b) { return a.excess < b.excess; });
    const bool is_good = worst->excess <= options.excess * whole || parts.size() + done.size() >= options.most;
    std::optional<std::array<RoughPart, 2>> cut = is_good ? std::nullopt : best_cut(*worst);
    if (cut) {
      *worst = std::move((*cut)[0]);
      parts.push_back(std::move((*cut)[1]));
    } else {
      done.push_back(std::move(*worst));
      parts.erase(worst);
    }
  }
  std::vector<ConvexHull> hulls;
  for (const RoughPart& part : done) {
    ConvexHull hull = trimmed(convex_hull(part.surface.points(), options.corners), part.surface, options);
    if (!hull.triangle.empty()) hulls.push_back(std::move(hull));
  }
  return hulls;
}

}  // namespace pomona
