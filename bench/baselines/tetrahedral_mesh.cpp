#include "bench/baselines/tetrahedral_mesh.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Random.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/refine_mesh_3.h>
#include <boost/property_map/function_property_map.hpp>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pomona::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;
using Face = SurfaceMesh::Face_index;
using Polyhedron = CGAL::Mesh_polyhedron_3<Kernel>::type;
using Domain = CGAL::Polyhedral_mesh_domain_with_features_3<Kernel, Polyhedron>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain, CGAL::Default, CGAL::Sequential_tag>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Domain::Corner_index, Domain::Curve_index>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;
using Polygons = std::vector<std::vector<std::size_t>>;
namespace processing = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;

/// Triangles of some area between points; equal positions are one point.
struct Soup {
  std::vector<Point> points;
  Polygons polygons;
  std::vector<std::int32_t> surface;  ///< one entry per polygon
};

Soup welded(const DiffusionSurfaces& surfaces) {
  Soup soup;
  std::map<std::array<float, 3>, std::size_t> known;
  const auto index_of = [&](const glm::vec3& p) {
    const auto [at, is_new] = known.try_emplace({p.x, p.y, p.z}, soup.points.size());
    if (is_new) soup.points.emplace_back(p.x, p.y, p.z);
    return at->second;
  };
  for (std::size_t t = 0; t < surfaces.triangle_count(); ++t) {
    const glm::uvec3& v = surfaces.triangle[t];
    const std::size_t a = index_of(surfaces.position[v.x]), b = index_of(surfaces.position[v.y]),
                      c = index_of(surfaces.position[v.z]);
    if (CGAL::collinear(soup.points[a], soup.points[b], soup.points[c])) continue;
    soup.polygons.push_back({a, b, c});
    soup.surface.push_back(surfaces.surface[t]);
  }
  return soup;
}

SurfaceMesh mesh_of(Soup& soup) {
  SurfaceMesh mesh;
  processing::orient_polygon_soup(soup.points, soup.polygons);
  processing::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  return mesh;
}

/// "skin and chamber (214 pairs of triangles)" for the two surfaces that cross most often; empty if none cross.
std::string crossing_surfaces(const SurfaceMesh& mesh, const Soup& soup, const std::vector<std::string>& names) {
  std::vector<std::pair<Face, Face>> pairs;
  processing::self_intersections(mesh, std::back_inserter(pairs));
  if (pairs.empty()) return {};
  std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> count;
  for (const auto& [a, b] : pairs) ++count[std::minmax(soup.surface[a], soup.surface[b])];
  const auto max =
      std::max_element(count.begin(), count.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  const auto& [first, second] = max->first;
  const std::string who = first == second ? names[first] + " and itself" : names[first] + " and " + names[second];
  return who + " (" + std::to_string(max->second) + " pairs of triangles)";
}

double diagonal(const CGAL::Bbox_3& box) {
  return glm::length(glm::dvec3(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()));
}

Polyhedron polyhedron_of(const Soup& soup, const std::vector<std::size_t>& chosen) {
  // Keep only the points in use.
  std::vector<Point> points;
  Polygons polygons;
  std::map<std::size_t, std::size_t> index;
  for (const std::size_t p : chosen) {
    std::vector<std::size_t> polygon;
    for (const std::size_t corner : soup.polygons[p]) {
      const auto [at, is_new] = index.try_emplace(corner, points.size());
      if (is_new) points.push_back(soup.points[corner]);
      polygon.push_back(at->second);
    }
    polygons.push_back(std::move(polygon));
  }
  processing::orient_polygon_soup(points, polygons);
  Polyhedron polyhedron;
  processing::polygon_soup_to_polygon_mesh(points, polygons, polyhedron);
  return polyhedron;
}

/// The outermost surface, and all others.
struct Shells {
  Polyhedron outer = {}, inner = {};
  std::string why_not = {};
};

Shells shells_of(const SurfaceMesh& mesh, const Soup& soup) {
  // Sort the triangles by connected component.
  std::vector<std::size_t> component(mesh.number_of_faces());
  const auto component_map =
      boost::make_function_property_map<Face>([&](Face f) -> std::size_t& { return component[f]; });
  const std::size_t count = processing::connected_components(mesh, component_map);
  std::vector<std::vector<std::size_t>> members(count);
  for (std::size_t f = 0; f < component.size(); ++f) members[component[f]].push_back(f);

  // The largest component must enclose the others.
  std::vector<CGAL::Bbox_3> box(count);
  for (const Face f : mesh.faces()) box[component[f]] += processing::face_bbox(f, mesh);
  const auto outermost = static_cast<std::size_t>(
      std::max_element(box.begin(), box.end(), [](const auto& a, const auto& b) { return diagonal(a) < diagonal(b); }) -
      box.begin());
  Shells shells{.outer = polyhedron_of(soup, members[outermost])};
  if (!CGAL::is_closed(shells.outer)) return {.why_not = "the outermost surface is open"};
  const CGAL::Side_of_triangle_mesh<Polyhedron, Kernel> side(shells.outer);
  std::vector<std::size_t> others;
  for (std::size_t c = 0; c < count; ++c) {
    if (c == outermost) continue;
    if (side(soup.points[soup.polygons[members[c].front()].front()]) != CGAL::ON_BOUNDED_SIDE) {
      return {.why_not = "no surface holds all others"};
    }
    others.insert(others.end(), members[c].begin(), members[c].end());
  }
  shells.inner = polyhedron_of(soup, others);
  return shells;
}

/// Puts some corners of every connected part into the mesh at first. The refinement finds surfaces by random rays and
/// would miss small ones.
void insert_corners_of_all_parts(const Domain& domain, Complex& complex) {
  constexpr std::size_t corners_per_part = 12;
  const auto weighted = complex.triangulation().geom_traits().construct_weighted_point_3_object();
  for (const Polyhedron& polyhedron : domain.polyhedra()) {
    // Gather the corners of each part, once each, in the order of the faces.
    std::map<Polyhedron::Facet_const_handle, std::size_t> part_of_face;
    const std::size_t count =
        processing::connected_components(polyhedron, boost::make_assoc_property_map(part_of_face));
    std::vector<std::vector<Polyhedron::Halfedge_const_handle>> part(count);
    std::set<Polyhedron::Vertex_const_handle> seen;
    for (const auto face : CGAL::faces(polyhedron)) {
      for (const auto edge : CGAL::halfedges_around_face(CGAL::halfedge(face, polyhedron), polyhedron)) {
        if (seen.insert(edge->vertex()).second) part[part_of_face.at(face)].push_back(edge);
      }
    }

    // Insert some, unless a crease holds the place already.
    for (const auto& edges : part) {
      for (std::size_t i = 0; i < std::min(corners_per_part, edges.size()); ++i) {
        const auto& edge = edges[i * edges.size() / std::min(corners_per_part, edges.size())];
        const auto vertex = complex.triangulation().insert(weighted(edge->vertex()->point()));
        const bool is_new = vertex != Complex::Vertex_handle() && complex.in_dimension(vertex) < 0;
        if (!is_new) continue;
        complex.set_dimension(vertex, 2);
        complex.set_index(vertex, domain.index_from_surface_patch_index(edge->face()->patch_id()));
      }
    }
  }
}

/// Cells next to a small part of the surfaces are small like it, and grow with the distance from it.
class Sizes {
 public:
  using FT = Kernel::FT;

  /// \param largest of all cells; \param whole the diagonal of all surfaces: both in metres
  Sizes(const Polyhedron& inner, double largest, double whole) : largest_(largest), growth_(5 * largest / whole) {
    std::map<Polyhedron::Facet_const_handle, std::size_t> part_of_face;
    std::vector<CGAL::Bbox_3> box(
        processing::connected_components(inner, boost::make_assoc_property_map(part_of_face)));
    for (const auto face : CGAL::faces(inner)) box[part_of_face.at(face)] += processing::face_bbox(face, inner);

    // A small part gets cells twice as coarse for its size as the whole does, but no finer than a twelfth of it.
    const double share = std::max(2 * largest / whole, 1.0 / 12);
    for (const CGAL::Bbox_3& b : box) {
      const double size = share * diagonal(b);
      if (size < largest) small_.push_back({{b.xmin(), b.ymin(), b.zmin()}, {b.xmax(), b.ymax(), b.zmax()}, size});
    }
  }

  template <typename Index>
  FT operator()(const Point& p, int, const Index&) const {
    double size = largest_;
    for (const Part& part : small_) {
      const glm::dvec3 at(p.x(), p.y(), p.z());
      const double away = glm::length(glm::max(glm::max(part.low - at, at - part.high), glm::dvec3(0)));
      size = std::min(size, part.size + growth_ * away);
    }
    return size;
  }

 private:
  struct Part {
    glm::dvec3 low, high;
    double size;
  };
  double largest_, growth_;
  std::vector<Part> small_;
};

Complex refined(const Shells& shells, double cell_size) {
  // The angle of a sharp edge: creases of a box, not the facets of a small seed.
  constexpr double sharp_degrees = 75;
  CGAL::get_default_random() = CGAL::Random(0);
  std::vector<const Polyhedron*> inner;
  if (!shells.inner.empty()) inner.push_back(&shells.inner);
  Domain domain(inner.begin(), inner.end(), shells.outer);
  domain.detect_features(sharp_degrees);

  // Time limits are off: with them the mesh would depend on how fast the machine is.
  const Sizes sizes(shells.inner, cell_size, diagonal(processing::bbox(shells.outer)));
  const Criteria criteria(parameters::edge_size = sizes, parameters::facet_angle = 25, parameters::facet_size = sizes,
                          parameters::facet_distance = cell_size / 20, parameters::cell_radius_edge_ratio = 2.5,
                          parameters::cell_size = sizes);
  Complex complex;
  CGAL::Mesh_3::internal::C3t3_initializer<Complex, Domain, Criteria, true>()(complex, domain, criteria, true);
  insert_corners_of_all_parts(domain, complex);
  CGAL::refine_mesh_3(complex, domain, criteria, parameters::perturb(parameters::time_limit = 0),
                      parameters::exude(parameters::time_limit = 0), parameters::no_reset_c3t3());
  return complex;
}

TetrahedralMesh plain(const Complex& complex) {
  // Number the vertices in use.
  std::map<Complex::Vertex_handle, std::uint32_t> vertex;
  std::map<Complex::Cell_handle, std::uint32_t> cell;
  TetrahedralMesh mesh;
  for (auto c = complex.cells_in_complex_begin(); c != complex.cells_in_complex_end(); ++c) {
    const auto index = static_cast<std::uint32_t>(cell.size());
    cell.emplace(c, index);
    std::array<std::uint32_t, 4> corner{};
    for (int i = 0; i < 4; ++i) {
      const auto [at, is_new] = vertex.try_emplace(c->vertex(i), static_cast<std::uint32_t>(mesh.position.size()));
      if (is_new) {
        const auto& p = c->vertex(i)->point();
        mesh.position.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
      }
      corner[static_cast<std::size_t>(i)] = at->second;
    }
    mesh.corner.push_back(corner);
  }

  // Connect the tetrahedra.
  for (auto c = complex.cells_in_complex_begin(); c != complex.cells_in_complex_end(); ++c) {
    std::array<std::uint32_t, 4> neighbor{};
    std::array<bool, 4> on_surface{};
    for (int i = 0; i < 4; ++i) {
      const auto beyond = cell.find(c->neighbor(i));
      neighbor[static_cast<std::size_t>(i)] = beyond == cell.end() ? TetrahedralMesh::none : beyond->second;
      on_surface[static_cast<std::size_t>(i)] = complex.is_in_complex(c, i);
    }
    mesh.neighbor.push_back(neighbor);
    mesh.on_surface.push_back(on_surface);
  }
  return mesh;
}

}  // namespace

TetrahedralMeshing make_tetrahedral_mesh(const DiffusionSurfaces& surfaces, double cell_size) {
  Soup soup = welded(surfaces);
  const SurfaceMesh mesh = mesh_of(soup);
  const std::string crossing = crossing_surfaces(mesh, soup, surfaces.surface_names);
  if (!crossing.empty()) return {{}, "surfaces cross or touch each other: " + crossing};
  const Shells shells = shells_of(mesh, soup);
  if (!shells.why_not.empty()) return {{}, shells.why_not};
  return {plain(refined(shells, cell_size)), {}};
}

}  // namespace pomona::bench
