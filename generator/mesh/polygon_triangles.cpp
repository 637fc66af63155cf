#include "generator/mesh/polygon_triangles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

using PolygonKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CornerBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, PolygonKernel>;  // the number of a corner
enum class Part : std::uint8_t { unknown, outside, inside };
using SideBase =
    CGAL::Constrained_triangulation_face_base_2<PolygonKernel,
                                                CGAL::Triangulation_face_base_with_info_2<Part, PolygonKernel>>;
using PolygonTriangulation =
    CGAL::Constrained_Delaunay_triangulation_2<PolygonKernel,
                                               CGAL::Triangulation_data_structure_2<CornerBase, SideBase>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Point = PolygonTriangulation::Point;
using PolygonFace = PolygonTriangulation::Face_handle;
using Edge = std::pair<std::uint32_t, std::uint32_t>;  // the lower corner first

std::vector<glm::uvec3> fan_of(std::size_t corners) {
  std::vector<glm::uvec3> fan;
  for (std::uint32_t k = 2; k < corners; ++k) fan.emplace_back(0u, k - 1, k);
  return fan;
}

/// Twice the polygon's area along its normal [Newell]; and twice that of its fan, each triangle counted as positive.
struct Areas {
  glm::dvec3 polygon{0};
  double fan = 0;
};

Areas areas_of(std::span<const glm::dvec3> corners) {
  Areas areas;
  for (std::size_t k = 2; k < corners.size(); ++k) {
    const glm::dvec3 area = glm::cross(corners[k - 1] - corners[0], corners[k] - corners[0]);
    areas.polygon += area;
    areas.fan += glm::length(area);
  }
  return areas;
}

/// The corners seen along the axis that lies nearest to the normal, so that the polygon runs counter-clockwise. No
/// coordinate is changed: what lay on a line still does.
std::vector<Point> seen_flat(std::span<const glm::dvec3> corners, const glm::dvec3& normal) {
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (std::fabs(normal[k]) > std::fabs(normal[axis])) axis = k;
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(u, v);
  std::vector<Point> flat;
  for (const glm::dvec3& p : corners) flat.emplace_back(p[u], p[v]);
  return flat;
}

bool is_filled_by_fan(const std::vector<Point>& flat) {
  for (std::size_t k = 2; k < flat.size(); ++k)
    if (CGAL::orientation(flat[0], flat[k - 1], flat[k]) != CGAL::LEFT_TURN) return false;
  return true;
}

double twice_area(const Point& a, const Point& b, const Point& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y());
}

/// The triangulation of a polygon's border.
class Filling {
 public:
  explicit Filling(const std::vector<Point>& flat) : flat_(flat) {}

  /// Nothing where the border crosses or touches itself.
  std::optional<std::vector<glm::uvec3>> triangles() {
    if (!draw_border()) return {};
    mark();
    std::vector<glm::uvec3> triangles;
    double area = 0, wanted = 0;
    for (const PolygonFace face : mesh_.finite_face_handles()) {
      if (face->info() != Part::inside) continue;
      glm::uvec3 t(face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info());
      while (t.x > t.y || t.x > t.z) t = {t.y, t.z, t.x};
      triangles.push_back(t);
      area += twice_area(flat_[t.x], flat_[t.y], flat_[t.z]);
    }
    // Loops that touch and turn against each other would be filled the wrong way round.
    for (std::size_t k = 2; k < flat_.size(); ++k) wanted += twice_area(flat_[0], flat_[k - 1], flat_[k]);
    if (triangles.empty() || !(std::fabs(area - wanted) <= 1e-6 * wanted)) return {};
    std::sort(triangles.begin(), triangles.end(), [](const glm::uvec3& l, const glm::uvec3& r) {
      return std::tie(l.x, l.y, l.z) < std::tie(r.x, r.y, r.z);
    });
    return triangles;
  }

 private:
  bool draw_border() {
    std::vector<PolygonTriangulation::Vertex_handle> vertex;
    for (std::uint32_t k = 0; k < flat_.size(); ++k) {
      const std::size_t before = mesh_.number_of_vertices();
      vertex.push_back(mesh_.insert(flat_[k]));
      if (mesh_.number_of_vertices() > before) vertex.back()->info() = k;
    }
    std::vector<Edge> edges;
    try {
      for (std::size_t k = 0; k < vertex.size(); ++k) {
        const auto from = vertex[k], to = vertex[(k + 1) % vertex.size()];
        if (from == to) continue;
        mesh_.insert_constraint(from, to);
        edges.emplace_back(std::minmax(from->info(), to->info()));
        if (!mesh_.is_edge(from, to)) return false;  // it runs through a corner
      }
    } catch (const PolygonTriangulation::Intersection_of_constraints_exception&) {
      return false;
    }
    // An edge that is passed twice, there and back, is no border.
    for (const Edge& edge : edges) is_border_[edge] = !is_border_[edge];
    return mesh_.dimension() == 2;
  }

  void mark() {
    for (const PolygonFace face : mesh_.all_face_handles()) face->info() = Part::unknown;
    std::vector<PolygonFace> open{mesh_.infinite_face()};
    open.front()->info() = Part::outside;
    while (!open.empty()) {
      const PolygonFace face = open.back();
      open.pop_back();
      for (int k = 0; k < 3; ++k) {
        const PolygonFace beyond = face->neighbor(k);
        if (beyond->info() != Part::unknown) continue;
        const bool crosses = is_border(face, k), inside = (face->info() == Part::inside) != crosses;
        beyond->info() = inside ? Part::inside : Part::outside;
        open.push_back(beyond);
      }
    }
  }

  bool is_border(PolygonFace face, int k) const {
    if (!face->is_constrained(k)) return false;
    const auto found = is_border_.find(std::minmax(face->vertex(PolygonTriangulation::ccw(k))->info(),
                                                   face->vertex(PolygonTriangulation::cw(k))->info()));
    return found != is_border_.end() && found->second;
  }

  const std::vector<Point>& flat_;
  PolygonTriangulation mesh_;
  std::map<Edge, bool> is_border_;
};

}  // namespace

std::optional<std::vector<glm::uvec3>> polygon_triangles(std::span<const glm::dvec3> corners) {
  if (corners.size() <= 3) return fan_of(corners.size());
  const Areas areas = areas_of(corners);
  double longest = 0;  // squared
  for (const glm::dvec3& p : corners) longest = std::max(longest, glm::dot(p - corners[0], p - corners[0]));
  constexpr double no_area = 1e-12;  // an area below this share of the squared length counts as none
  if (!(areas.fan > no_area * longest)) return fan_of(corners.size());
  if (!(glm::length(areas.polygon) > no_area * areas.fan)) return {};
  const std::vector<Point> flat = seen_flat(corners, areas.polygon);
  if (is_filled_by_fan(flat)) return fan_of(corners.size());
  return Filling(flat).triangles();
}

}  // namespace pomona
