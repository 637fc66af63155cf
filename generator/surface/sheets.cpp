#include "generator/surface/sheets.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "generator/mesh/edges.h"
#include "generator/mesh/weld.h"
#include "generator/surface/bodies.h"

namespace pomona {

namespace {

class SheetDistances {
 public:
  SheetDistances(const DiffusionSurfaces& surfaces, const std::vector<glm::vec3>& normals)
      : surfaces_(surfaces), normals_(normals), first_(weld(surfaces.position)) {}

  std::vector<float> find() {
    start_with_blur();
    for_each_edge(sorted_half_edges(welded_triangles(first_, surfaces_.triangle)),
                  [&](std::span<const HalfEdge> edge) { limit_at(edge); });
    std::vector<float> distances(surfaces_.vertex_count());
    for (std::size_t v = 0; v < distances.size(); ++v) distances[v] = static_cast<float>(distance_[first_[v]]);
    return distances;
  }

 private:
  /// The smallest blur of all vertices at one position, so that sheets do not tear.
  void start_with_blur() {
    distance_.assign(surfaces_.vertex_count(), 0);
    for (std::size_t v = 0; v < distance_.size(); ++v) {
      const double blur = std::max(0.0f, surfaces_.blur[v]);
      double& known = distance_[first_[v]];
      known = first_[v] == v ? blur : std::min(known, blur);
    }
  }

  void limit_at(std::span<const HalfEdge> edge) {
    const std::uint32_t a = edge.front().low, b = edge.front().high;
    std::size_t boundary = 0;
    bool outwards = false, inwards = false;  // along the normal, against it
    for (const HalfEdge& h : edge) {
      const bool is_boundary = surfaces_.is_boundary(h.triangle);
      boundary += is_boundary ? 1 : 0;
      outwards = outwards || !is_boundary || surfaces_.is_hidden(h.triangle, SideOf::back);
      inwards = inwards || !is_boundary || surfaces_.is_hidden(h.triangle, SideOf::front);
    }
    const bool rim = edge.size() == 1;
    const bool changes = boundary != 0 && boundary != edge.size();
    const double max = rim || changes ? 0 : farthest_unfolded(a, b, outwards, inwards);
    distance_[a] = std::min(distance_[a], max);
    distance_[b] = std::min(distance_[b], max);
  }

  /// 0.4 of the radius by which the normals of an edge's ends turn along it, if towards a moving sheet.
  double farthest_unfolded(std::uint32_t a, std::uint32_t b, bool outwards, bool inwards) const {
    const glm::dvec3 edge = glm::dvec3(surfaces_.position[b]) - glm::dvec3(surfaces_.position[a]);
    const double spread = glm::dot(glm::dvec3(normals_[b]) - glm::dvec3(normals_[a]), edge);
    const double closing = std::max(outwards ? -spread : 0.0, inwards ? spread : 0.0);
    constexpr double share_of_radius = 0.4;
    const double unlimited = std::max(distance_[a], distance_[b]);
    return closing > 0 ? std::min(unlimited, share_of_radius * glm::dot(edge, edge) / closing) : unlimited;
  }

  const DiffusionSurfaces& surfaces_;
  const std::vector<glm::vec3>& normals_;
  std::vector<std::uint32_t> first_;
  std::vector<double> distance_;  ///< per welded vertex
};

/// Per vertex the distance by which a sheet moves along the normal, metres; equal at equal positions. It is the blur,
/// but 0 at open rims and where the boundary meets an inner surface. It is at most 0.4 times the radius of curvature on
/// the side to which the sheet moves, so that no sheet folds over itself.
std::vector<float> sheet_distances(const DiffusionSurfaces& surfaces, const std::vector<glm::vec3>& normals) {
  return SheetDistances(surfaces, normals).find();
}

/// The sheets of a triangle. A vertex that triangles use in several ways is doubled.
enum class Role : std::uint8_t {
  whole_inner,     ///< stays, with both colours
  whole_boundary,  ///< stays, with both colours, one side hidden
  front_sheet,     ///< moves along the normal, the front's colour on both faces
  back_sheet,      ///< moves against the normal, the back's colour on both faces
  front_air,       ///< stays, the hidden front's colour on both faces
  back_air,        ///< stays, the hidden back's colour on both faces
};
constexpr std::size_t role_count = 6;

class SheetMaker {
 public:
  explicit SheetMaker(const DiffusionSurfaces& surfaces)
      : from_(surfaces), normals_(vertex_normals(surfaces)), distances_(sheet_distances(surfaces, normals_)) {
    std::array<std::uint32_t, role_count> none{};
    none.fill(no_vertex);
    copies_.assign(surfaces.vertex_count(), none);
    min_ = 1e-6 * glm::length(bounds_of(surfaces).size());
  }

  DiffusionSurfaces make() {
    to_.surface_names = from_.surface_names;
    to_.part_names = from_.part_names;
    to_.notes = from_.notes;
    // All whole triangles and first sheets, in the order of the triangles; then all second sheets.
    for (std::size_t i = 0; i < from_.triangle_count(); ++i) append(i, first_role(i));
    for (std::size_t i = 0; i < from_.triangle_count(); ++i) {
      if (splits(i)) append(i, second_role(i));
    }
    return std::move(to_);
  }

 private:
  static constexpr std::uint32_t no_vertex = UINT32_MAX;

  bool splits(std::size_t i) const {
    const glm::uvec3& t = from_.triangle[i];
    const bool both_hidden = from_.is_hidden(i, SideOf::front) && from_.is_hidden(i, SideOf::back);
    return !both_hidden && (moves(t.x) || moves(t.y) || moves(t.z));
  }

  bool moves(std::uint32_t vertex) const { return static_cast<double>(distances_[vertex]) >= min_ && min_ > 0; }

  Role first_role(std::size_t i) const {
    const bool front_hidden = from_.is_hidden(i, SideOf::front), back_hidden = from_.is_hidden(i, SideOf::back);
    if (!splits(i)) return front_hidden || back_hidden ? Role::whole_boundary : Role::whole_inner;
    return front_hidden ? Role::front_air : back_hidden ? Role::back_air : Role::front_sheet;
  }

  Role second_role(std::size_t i) const {
    return from_.is_hidden(i, SideOf::back) ? Role::front_sheet : Role::back_sheet;
  }

  void append(std::size_t i, Role role) {
    const glm::uvec3& t = from_.triangle[i];
    // One statement each: compilers evaluate arguments in different orders, which would number vertices differently.
    glm::uvec3 corners;
    for (int k = 0; k < 3; ++k) corners[k] = vertex(t[k], role);
    to_.triangle.push_back(corners);
    to_.surface.push_back(from_.surface[i]);
    if (!from_.instance.empty()) to_.instance.push_back(from_.instance[i]);
    to_.front_part.push_back(shows_back(role) ? from_.back_part[i] : from_.front_part[i]);
    to_.back_part.push_back(shows_front(role) ? from_.front_part[i] : from_.back_part[i]);
  }

  static bool shows_front(Role role) { return role == Role::front_sheet || role == Role::front_air; }
  static bool shows_back(Role role) { return role == Role::back_sheet || role == Role::back_air; }

  std::uint32_t vertex(std::uint32_t v, Role role) {
    std::uint32_t& copy = copies_[v][static_cast<std::size_t>(role)];
    if (copy != no_vertex) return copy;
    copy = static_cast<std::uint32_t>(to_.vertex_count());
    to_.position.push_back(moved(v, role));
    to_.front_color.push_back(shows_back(role) ? from_.back_color[v] : from_.front_color[v]);
    to_.back_color.push_back(shows_front(role) ? from_.front_color[v] : from_.back_color[v]);
    to_.blur.push_back(0);
    const bool as_was = role == Role::whole_boundary;
    to_.front_hidden.push_back(role == Role::front_air ? 1 : as_was ? from_.front_hidden[v] : 0);
    to_.back_hidden.push_back(role == Role::back_air ? 1 : as_was ? from_.back_hidden[v] : 0);
    return copy;
  }

  glm::vec3 moved(std::uint32_t v, Role role) const {
    const double way = role == Role::front_sheet ? 1 : role == Role::back_sheet ? -1 : 0;
    if (way == 0 || !moves(v)) return from_.position[v];
    return glm::vec3(glm::dvec3(from_.position[v]) +
                     way * static_cast<double>(distances_[v]) * glm::dvec3(normals_[v]));
  }

  const DiffusionSurfaces& from_;
  std::vector<glm::vec3> normals_;
  std::vector<float> distances_;
  double min_ = 0;  ///< sheets nearer than this stay one surface
  std::vector<std::array<std::uint32_t, role_count>> copies_;
  DiffusionSurfaces to_;
};

}  // namespace

DiffusionSurfaces sheets(const DiffusionSurfaces& surfaces) { return SheetMaker(surfaces).make(); }

}  // namespace pomona
