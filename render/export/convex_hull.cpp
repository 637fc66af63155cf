#include "render/export/convex_hull.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

using InexactKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = InexactKernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;

Point to_cgal(const glm::vec3& p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}

/// CGAL's points are ours, unchanged, so going back to floats loses nothing.
glm::vec3 from_cgal(const Point& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

bool is_before(const glm::vec3& a, const glm::vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

std::array<Point, 3> corners_of(const Surface& surface, Surface::Face_index face) {
  const auto edge = surface.halfedge(face);
  return {surface.point(surface.source(edge)), surface.point(surface.target(edge)),
          surface.point(surface.target(surface.next(edge)))};
}

/// The triangles of a hull in groups that lie in a plane each.
std::vector<std::vector<Surface::Face_index>> flat_faces(const Surface& surface) {
  std::set<Surface::Face_index> taken;
  std::vector<std::vector<Surface::Face_index>> groups;
  for (const Surface::Face_index start : surface.faces()) {
    const auto [p, q, r] = corners_of(surface, start);
    if (taken.contains(start) || CGAL::collinear(p, q, r)) continue;
    const auto is_in_plane = [&, &a = p, &b = q, &c = r](Surface::Face_index face) {
      const std::array<Point, 3> corners = corners_of(surface, face);
      return std::all_of(corners.begin(), corners.end(),
                         [&](const Point& corner) { return CGAL::coplanar(a, b, c, corner); });
    };
    taken.insert(start);
    std::vector<Surface::Face_index> group{start};
    for (std::size_t i = 0; i < group.size(); ++i) {
      for (const auto edge : surface.halfedges_around_face(surface.halfedge(group[i]))) {
        const Surface::Face_index beside = surface.face(surface.opposite(edge));
        if (!taken.contains(beside) && is_in_plane(beside)) taken.insert(beside), group.push_back(beside);
      }
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

/// The corners of a flat face in their order, without those within an edge.
std::vector<Surface::Vertex_index> rim_of(const Surface& surface, const std::vector<Surface::Face_index>& group) {
  std::map<Surface::Vertex_index, Surface::Vertex_index> next;
  for (const Surface::Face_index face : group) {
    for (const auto edge : surface.halfedges_around_face(surface.halfedge(face))) {
      const bool is_rim = std::find(group.begin(), group.end(), surface.face(surface.opposite(edge))) == group.end();
      if (is_rim) next[surface.source(edge)] = surface.target(edge);
    }
  }
  std::vector<Surface::Vertex_index> corners;
  for (const auto& [before, at] : next) {
    const bool is_corner = !CGAL::collinear(surface.point(before), surface.point(at), surface.point(next.at(at)));
    if (is_corner) corners.push_back(at);
  }
  if (corners.empty()) return {};
  const std::set<Surface::Vertex_index> real(corners.begin(), corners.end());
  std::vector<Surface::Vertex_index> around;
  const Surface::Vertex_index first = corners.front();
  for (Surface::Vertex_index at = first; around.empty() || at != first; at = next.at(at))
    if (real.contains(at)) around.push_back(at);
  return around;
}

/// Sorts vertices by place, and triangles from their smallest vertex on. CGAL divides flat faces otherwise in each run,
/// by where things lie in memory: here they are fans around their smallest corner.
ConvexHull ordered(const Surface& surface) {
  std::vector<std::vector<Point>> faces;
  ConvexHull hull;
  for (const std::vector<Surface::Face_index>& group : flat_faces(surface)) {
    faces.emplace_back();
    for (const Surface::Vertex_index corner : rim_of(surface, group)) {
      faces.back().push_back(surface.point(corner));
      hull.position.push_back(from_cgal(faces.back().back()));
    }
  }
  std::sort(hull.position.begin(), hull.position.end(), is_before);
  hull.position.erase(std::unique(hull.position.begin(), hull.position.end()), hull.position.end());
  const auto number_of = [&](const Point& point) {
    const auto at = std::lower_bound(hull.position.begin(), hull.position.end(), from_cgal(point), is_before);
    return static_cast<std::uint32_t>(at - hull.position.begin());
  };
  for (const std::vector<Point>& face : faces) {
    std::vector<std::uint32_t> corner;
    for (const Point& point : face) corner.push_back(number_of(point));
    std::rotate(corner.begin(), std::min_element(corner.begin(), corner.end()), corner.end());
    for (std::size_t k = 2; k < corner.size(); ++k) hull.triangle.emplace_back(corner[0], corner[k - 1], corner[k]);
  }
  std::sort(hull.triangle.begin(), hull.triangle.end(),
            [](const glm::uvec3& a, const glm::uvec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
  return hull;
}

/// \param points distinct, sorted by place.
ConvexHull whole_hull(const std::vector<glm::vec3>& points) {
  std::vector<Point> given;
  for (const glm::vec3& p : points) given.push_back(to_cgal(p));
  if (given.size() < 4) return {};
  Surface surface;
  CGAL::convex_hull_3(given.begin(), given.end(), surface);
  return surface.number_of_faces() >= 4 ? ordered(surface) : ConvexHull{};
}

/// The up to 14 points that are farthest along the axes and diagonals.
std::vector<glm::vec3> farthest_along_directions(const std::vector<glm::vec3>& points) {
  std::vector<glm::vec3> found;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const int axes = std::abs(x) + std::abs(y) + std::abs(z);
        if (axes != 1 && axes != 3) continue;
        const glm::dvec3 along(x, y, z);
        found.push_back(*std::max_element(points.begin(), points.end(), [&](const glm::vec3& a, const glm::vec3& b) {
          return glm::dot(glm::dvec3(a), along) < glm::dot(glm::dvec3(b), along);
        }));
      }
    }
  }
  std::sort(found.begin(), found.end(), is_before);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// The point that is farthest outside of a hull, if any.
std::optional<glm::vec3> farthest_outside(const ConvexHull& hull, const std::vector<glm::vec3>& points) {
  std::optional<glm::vec3> farthest;
  double distance = 1e-9;  // metres
  for (const glm::uvec3& t : hull.triangle) {
    const glm::dvec3 a(hull.position[t.x]), b(hull.position[t.y]), c(hull.position[t.z]);
    const glm::dvec3 area = glm::cross(b - a, c - a);
    const double length = glm::length(area);
    if (!(length > 0)) continue;
    for (const glm::vec3& p : points) {
      const double height = glm::dot(glm::dvec3(p) - a, area) / length;
      if (height > distance) distance = height, farthest = p;
    }
  }
  return farthest;
}

}  // namespace

ConvexHull convex_hull(std::span<const glm::vec3> points, std::size_t max) {
  std::vector<glm::vec3> different(points.begin(), points.end());
  std::sort(different.begin(), different.end(), is_before);
  different.erase(std::unique(different.begin(), different.end()), different.end());
  const ConvexHull whole = whole_hull(different);
  if (whole.position.size() <= max) return whole;

  // Grows a rough hull, a point at a time. Each point is tried once: beside a sliver of a face, whose normal is known
  // only roughly, a corner of the hull or a point within may seem to lie outside, again and again.
  std::vector<glm::vec3> chosen = farthest_along_directions(whole.position), left = whole.position;
  ConvexHull hull = whole_hull(chosen);
  while (hull.position.size() < max) {
    const std::optional<glm::vec3> next = farthest_outside(hull, left);
    if (!next) break;
    left.erase(std::lower_bound(left.begin(), left.end(), *next, is_before));
    chosen = hull.position;
    chosen.push_back(*next);
    std::sort(chosen.begin(), chosen.end(), is_before);
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    hull = whole_hull(chosen);
  }
  return hull;
}

}  // namespace pomona
