#include "generator/cut/carve/exact_points.h"

#include <algorithm>
#include <bit>
#include <memory>
#include <optional>
#include <unordered_map>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "generator/base/left_in_flight.h"

namespace pomona {

namespace {

using Exact = CGAL::Exact_rational;
using Vector = std::array<Exact, 3>;
using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;

constexpr std::uint32_t unset = 0xffffffffu;

struct PlaceNumber {
  std::uint32_t value = unset;
};
using PlaceVertexBase = CGAL::Triangulation_vertex_base_with_info_2<PlaceNumber, ExactKernel>;
using PlaceFaceBase = CGAL::Constrained_triangulation_face_base_2<ExactKernel>;
using PlaceDelaunay = CGAL::Constrained_Delaunay_triangulation_2<
    ExactKernel, CGAL::Triangulation_data_structure_2<PlaceVertexBase, PlaceFaceBase>, CGAL::Exact_intersections_tag>;
using PlaceTriangulation = CGAL::Constrained_triangulation_plus_2<PlaceDelaunay>;
using PlaceVertex = PlaceTriangulation::Vertex_handle;

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Exact dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector normal_of(const Vector& a, const Vector& b, const Vector& c) { return cross(minus(b, a), minus(c, a)); }

struct SameBits {
  std::size_t operator()(const std::array<double, 3>& p) const {
    std::uint64_t h = 0;
    for (const double x : p) h = (h ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u + (h >> 29);
    return static_cast<std::size_t>(h);
  }
};

/// The key of a point. Zeros of both signs are equal.
std::array<double, 3> key_of(const glm::dvec3& p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; }

}  // namespace

struct ExactPoints::Data {
  std::vector<glm::dvec3> rounded;
  std::vector<std::optional<Vector>> exact;  // filled on demand where the rounded point is exact
  std::unordered_map<std::array<double, 3>, std::vector<std::uint32_t>, SameBits> there;

  const Vector& at(std::uint32_t place) {
    std::optional<Vector>& known = exact[place];
    if (!known) known = {Exact(rounded[place].x), Exact(rounded[place].y), Exact(rounded[place].z)};
    return *known;
  }

  std::uint32_t number_of(Vector place) {
    const glm::dvec3 near(CGAL::to_double(place[0]), CGAL::to_double(place[1]), CGAL::to_double(place[2]));
    std::vector<std::uint32_t>& candidates = there[key_of(near)];
    for (const std::uint32_t other : candidates) {
      if (at(other) == place) return other;
    }
    const auto number = static_cast<std::uint32_t>(rounded.size());
    candidates.push_back(number);
    rounded.push_back(near);
    exact.emplace_back(std::move(place));
    return number;
  }
};

ExactPoints::ExactPoints() : data_(std::make_unique<Data>()) {}
ExactPoints::~ExactPoints() = default;

void ExactPoints::append(const glm::dvec3& place, bool known) {
  if (known) data_->there[key_of(place)].push_back(static_cast<std::uint32_t>(data_->rounded.size()));
  data_->rounded.push_back(place);
  data_->exact.emplace_back();
}

std::uint32_t ExactPoints::number_of(const glm::dvec3& place) {
  return data_->number_of({Exact(place.x), Exact(place.y), Exact(place.z)});
}

std::uint32_t ExactPoints::intersection(std::uint32_t p, std::uint32_t q,
                                        const std::array<std::uint32_t, 3>& triangle) {
  const Vector &a = data_->at(triangle[0]), &from = data_->at(p), &to = data_->at(q);
  const Vector normal = normal_of(a, data_->at(triangle[1]), data_->at(triangle[2]));
  const Exact before = dot(normal, minus(from, a)), after = dot(normal, minus(to, a));
  const Exact share = before / (before - after);
  Vector place;
  for (std::size_t i = 0; i < 3; ++i) place[i] = from[i] + share * (to[i] - from[i]);
  return data_->number_of(std::move(place));
}

std::size_t ExactPoints::count() const { return data_->rounded.size(); }
const glm::dvec3& ExactPoints::at(std::uint32_t place) const { return data_->rounded[place]; }

namespace {

/// Triangulates one facet in the plane of two axes.
template <typename At, typename NumberOf>
class FacetTriangulator {
 public:
  FacetTriangulator(const PatchedFacet& facet, const At& at, const NumberOf& number_of)
      : facet_(facet), at_(at), number_of_(number_of) {}

  FacetMesh run() {
    FacetMesh result;
    result.chain.resize(3 + facet_.segments.size());

    // A facet without area has no triangles: its chains lie on a line.
    if (!find_axes()) {
      for (std::size_t i = 0; i < result.chain.size(); ++i) result.chain[i] = chain_on_line(i);
      return result;
    }

    // Insert the corners, then all places and segments, which may cross.
    for (const std::uint32_t place : facet_.corner) insert(place);
    for (const std::uint32_t place : facet_.places) insert(place);
    for (std::size_t i = 0; i < 3; ++i) keep(facet_.corner[i], facet_.corner[(i + 1) % 3]);
    for (const std::array<std::uint32_t, 2>& s : facet_.segments) keep(s[0], s[1]);
    for (const PlaceVertex v : mesh_->finite_vertex_handles()) name(v);

    // Return triangles and chains in an order that does not depend on CGAL.
    for (const auto face : mesh_->finite_face_handles()) {
      std::array<std::uint32_t, 3> t{};
      for (int i = 0; i < 3; ++i) t[static_cast<std::size_t>(i)] = face->vertex(i)->info().value;
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      result.triangle.push_back(t);
    }
    std::sort(result.triangle.begin(), result.triangle.end());
    for (std::size_t i = 0; i < kept_.size(); ++i) result.chain[i] = chain(i);
    return result;
  }

 private:
  struct Kept {
    std::uint32_t from = 0;
    PlaceTriangulation::Constraint_id id{nullptr};
  };

  bool find_axes() {
    const Vector& a = at_(facet_.corner[0]);
    normal_ = normal_of(a, at_(facet_.corner[1]), at_(facet_.corner[2]));
    axis_ = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      if (CGAL::abs(normal_[i]) > CGAL::abs(normal_[axis_])) axis_ = i;
    }
    if (normal_[axis_] == 0) return false;
    u_ = (axis_ + 1) % 3;
    v_ = (axis_ + 2) % 3;
    if (normal_[axis_] < 0) std::swap(u_, v_);
    return true;
  }

  PlaceVertex insert(std::uint32_t place) {
    const auto [entry, is_new] = vertex_of_.try_emplace(place);
    if (is_new) {
      const Vector& p = at_(place);
      entry->second = mesh_->insert(ExactKernel::Point_2(ExactKernel::FT(p[u_]), ExactKernel::FT(p[v_])));
      entry->second->info().value = place;
    }
    return entry->second;
  }

  void keep(std::uint32_t from, std::uint32_t to) {
    Kept kept{from, PlaceTriangulation::Constraint_id(nullptr)};
    if (from != to) {
      const PlaceVertex a = insert(from), b = insert(to);
      kept.id = mesh_->insert_constraint(a, b);
    }
    kept_.push_back(kept);
  }

  /// Gives a crossing its place in space.
  void name(PlaceVertex v) {
    if (v->info().value != unset) return;
    const Vector& a = at_(facet_.corner[0]);
    Vector place;
    place[u_] = CGAL::exact(v->point().x());
    place[v_] = CGAL::exact(v->point().y());
    place[axis_] = a[axis_] - (normal_[u_] * (place[u_] - a[u_]) + normal_[v_] * (place[v_] - a[v_])) / normal_[axis_];
    v->info().value = number_of_(std::move(place));
  }

  std::vector<std::uint32_t> chain(std::size_t kept) const {
    if (!kept_[kept].id.vl_ptr()) return {kept_[kept].from};
    std::vector<std::uint32_t> all;
    for (auto v = mesh_->vertices_in_constraint_begin(kept_[kept].id);
         v != mesh_->vertices_in_constraint_end(kept_[kept].id); ++v) {
      all.push_back((*v)->info().value);
    }
    if (all.front() != kept_[kept].from) std::reverse(all.begin(), all.end());
    return all;
  }

  /// The chain of a facet whose corners lie on one line: all points between its ends, ordered by coordinates.
  std::vector<std::uint32_t> chain_on_line(std::size_t number) const {
    const std::uint32_t from = number < 3 ? facet_.corner[number] : facet_.segments[number - 3][0];
    const std::uint32_t to = number < 3 ? facet_.corner[(number + 1) % 3] : facet_.segments[number - 3][1];
    const auto less = [&](std::uint32_t a, std::uint32_t b) { return at_(a) < at_(b); };
    std::vector<std::uint32_t> all(facet_.corner.begin(), facet_.corner.end());
    all.insert(all.end(), facet_.places.begin(), facet_.places.end());
    std::sort(all.begin(), all.end(), less);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    const std::uint32_t low = less(from, to) ? from : to;
    const std::uint32_t high = low == from ? to : from;
    std::erase_if(all, [&](std::uint32_t place) { return less(place, low) || less(high, place); });
    if (low != from) std::reverse(all.begin(), all.end());
    return all;
  }

  const PatchedFacet& facet_;
  const At& at_;
  const NumberOf& number_of_;
  Vector normal_;
  std::size_t axis_ = 0, u_ = 1, v_ = 2;
  std::unique_ptr<PlaceTriangulation, LeftInFlight<PlaceTriangulation>> mesh_{new PlaceTriangulation};
  std::unordered_map<std::uint32_t, PlaceVertex> vertex_of_;
  std::vector<Kept> kept_;
};

}  // namespace

FacetMesh ExactPoints::triangulated(const PatchedFacet& facet) {
  const auto at = [&](std::uint32_t place) -> const Vector& { return data_->at(place); };
  const auto number_of = [&](Vector place) { return data_->number_of(std::move(place)); };
  return FacetTriangulator(facet, at, number_of).run();
}

}  // namespace pomona
