#include "generator/cut/plane/plane_triangulation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <glm/geometric.hpp>

#include "generator/mesh/edge_map.h"

namespace pomona {

namespace {

using InexactKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// The number of a vertex; -1 until it has one.
struct VertexNumber {
  std::int64_t value = -1;
  bool steiner = false;  // made by conform()
};
struct FaceNumber {
  std::int32_t value = -1;
};

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<VertexNumber, InexactKernel>;
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<InexactKernel,
                                                CGAL::Triangulation_face_base_with_info_2<FaceNumber, InexactKernel>>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<
    InexactKernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>, CGAL::Exact_predicates_tag>;
using Triangulation = CGAL::Constrained_triangulation_plus_2<Delaunay>;
using Vertex = Triangulation::Vertex_handle;
using FaceHandle = Triangulation::Face_handle;
using PlanePoint = Triangulation::Point;

PlanePoint to_point(const glm::dvec2& p) { return {p.x, p.y}; }
glm::dvec2 to_vec(const PlanePoint& p) { return {p.x(), p.y()}; }

}  // namespace

struct PlaneTriangulation::Data {
  Triangulation mesh;
  std::vector<Vertex> vertex;  // by number
  std::vector<std::uint32_t> stand_in;
  struct Kept {
    Triangulation::Constraint_id id;
    bool divisible = true;
  };
  std::vector<Kept> constraint;

  /// Numbers the points that constraints have made, in the order of the constraints.
  void number_new_vertices() {
    for (const Kept& kept : constraint) {
      if (!kept.id.vl_ptr()) continue;
      for (auto v = mesh.vertices_in_constraint_begin(kept.id); v != mesh.vertices_in_constraint_end(kept.id); ++v) {
        if ((*v)->info().value >= 0) continue;
        (*v)->info().value = static_cast<std::int64_t>(vertex.size());
        vertex.push_back(*v);
      }
    }
  }
};

PlaneTriangulation::PlaneTriangulation(std::span<const glm::dvec2> points, std::span<const PlaneConstraint> constraints)
    : data_(new Data) {
  FaceHandle hint;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vertex v = data_->mesh.insert(to_point(points[i]), hint);
    hint = v->face();
    if (v->info().value < 0) v->info().value = static_cast<std::int64_t>(i);
    data_->vertex.push_back(v);
    data_->stand_in.push_back(static_cast<std::uint32_t>(v->info().value));
  }
  for (const PlaneConstraint& c : constraints) {
    const Vertex a = data_->vertex[c.a], b = data_->vertex[c.b];
    data_->constraint.push_back(
        {a == b ? Triangulation::Constraint_id(nullptr) : data_->mesh.insert_constraint(a, b), c.divisible});
  }
  data_->number_new_vertices();
}

PlaneTriangulation::~PlaneTriangulation() = default;

void PlaneTriangulation::insert(std::span<const glm::dvec2> points) {
  FaceHandle hint;
  for (const glm::dvec2& p : points) {
    const Vertex v = data_->mesh.insert(to_point(p), hint);
    hint = v->face();
    if (v->info().value >= 0) continue;
    v->info().value = static_cast<std::int64_t>(data_->vertex.size());
    data_->vertex.push_back(v);
  }
}

TriangulatedPlane PlaneTriangulation::state() const {
  const Triangulation& mesh = data_->mesh;
  TriangulatedPlane state;
  state.stand_in = data_->stand_in;
  for (const Vertex v : data_->vertex) state.point.push_back(to_vec(v->point()));
  for (const Data::Kept& kept : data_->constraint) {
    state.chain.emplace_back();
    if (!kept.id.vl_ptr()) continue;
    for (auto v = mesh.vertices_in_constraint_begin(kept.id); v != mesh.vertices_in_constraint_end(kept.id); ++v) {
      state.chain.back().push_back(static_cast<std::uint32_t>((*v)->info().value));
    }
  }

  // Order the triangles by their corners, each from its smallest on.
  struct Row {
    std::array<std::uint32_t, 3> corner;
    FaceHandle face;
    int first;
  };
  std::vector<Row> rows;
  for (const FaceHandle f : mesh.finite_face_handles()) {
    const auto corner = [&](int i) { return static_cast<std::uint32_t>(f->vertex(i)->info().value); };
    int first = 0;
    for (int i = 1; i < 3; ++i) {
      if (corner(i) < corner(first)) first = i;
    }
    rows.push_back({{corner(first), corner((first + 1) % 3), corner((first + 2) % 3)}, f, first});
  }
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.corner < b.corner; });
  for (const FaceHandle f : mesh.all_face_handles()) f->info().value = TriangulatedPlane::none;
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].face->info().value = static_cast<std::int32_t>(i);

  // CGAL numbers an edge by the corner it does not touch.
  for (const Row& row : rows) {
    state.triangle.emplace_back(row.corner[0], row.corner[1], row.corner[2]);
    std::array<std::int32_t, 3> neighbor{};
    std::array<std::uint8_t, 3> constrained{};
    for (int i = 0; i < 3; ++i) {
      const int opposite = (row.first + i + 2) % 3;
      neighbor[static_cast<std::size_t>(i)] = row.face->neighbor(opposite)->info().value;
      constrained[static_cast<std::size_t>(i)] = row.face->is_constrained(opposite) ? 1 : 0;
    }
    state.neighbor.push_back(neighbor);
    state.constrained.push_back(constrained);
  }
  return state;
}

std::vector<std::int32_t> PlaneTriangulation::locate(std::span<const glm::dvec2> points) const {
  std::vector<std::int32_t> found;
  FaceHandle hint;
  for (const glm::dvec2& p : points) {
    hint = data_->mesh.locate(to_point(p), hint);
    found.push_back(hint == FaceHandle() ? TriangulatedPlane::none : hint->info().value);
  }
  return found;
}

namespace {

/// Splits constraints that are no Delaunay edges.
class Conformer {
 public:
  Conformer(Triangulation& mesh, double shortest) : mesh_(mesh), shortest_(shortest) {}

  void keep_whole(Vertex a, Vertex b) { whole_.insert(key(a, b)); }
  void queue(Vertex a, Vertex b) { waiting_.emplace_back(a, b); }

  void run() {
    while (!waiting_.empty()) {
      const auto [a, b] = waiting_.back();
      waiting_.pop_back();
      FaceHandle face;
      int edge = 0;
      if (!mesh_.is_edge(a, b, face, edge) || !face->is_constrained(edge) || whole_.contains(key(a, b))) continue;
      if (needs_split(face, edge)) split(a, b, face, edge);
    }
  }

 private:
  static EdgeKey key(Vertex a, Vertex b) {
    return {static_cast<std::uint32_t>(a->info().value), static_cast<std::uint32_t>(b->info().value)};
  }

  /// True if the corners across the edge see each other within one circle.
  bool needs_split(FaceHandle face, int edge) const {
    const FaceHandle other = face->neighbor(edge);
    const Vertex across = other->vertex(mesh_.mirror_index(face, edge));
    if (mesh_.is_infinite(face->vertex(edge)) || mesh_.is_infinite(across)) return false;
    return mesh_.side_of_oriented_circle(face, across->point()) == CGAL::ON_POSITIVE_SIDE;
  }

  /// The middle; but at a power of two from an end where other constraints may meet, so that constraints at a small
  /// angle do not split each other for ever (concentric shells: Ruppert 1995).
  static glm::dvec2 split_point(Vertex a, Vertex b) {
    glm::dvec2 from = to_vec(a->point()), to = to_vec(b->point());
    if (a->info().steiner == b->info().steiner) return 0.5 * (from + to);
    if (a->info().steiner) std::swap(from, to);
    const double length = glm::distance(from, to);
    int exponent = 0;
    const double mantissa = std::frexp(length, &exponent);  // length = mantissa * 2^exponent, 0.5 <= mantissa < 1
    const double distance = std::ldexp(mantissa < 0.75 ? 0.25 : 0.5, exponent);
    return from + (to - from) * (distance / length);
  }

  void split(Vertex a, Vertex b, FaceHandle face, int edge) {
    if (glm::distance(to_vec(a->point()), to_vec(b->point())) < 2 * shortest_) return;
    const PlanePoint middle = to_point(split_point(a, b));

    // Leave the edge alone where rounding has put the point beyond a very thin neighbour.
    const PlanePoint c = face->vertex(edge)->point(), d = mesh_.mirror_vertex(face, edge)->point();
    const PlanePoint from = face->vertex(Triangulation::ccw(edge))->point(),
                     to = face->vertex(Triangulation::cw(edge))->point();
    using CGAL::orientation;
    if (orientation(from, middle, c) != CGAL::LEFT_TURN || orientation(middle, to, c) != CGAL::LEFT_TURN) return;
    if (orientation(middle, from, d) != CGAL::LEFT_TURN || orientation(to, middle, d) != CGAL::LEFT_TURN) return;

    const Vertex v = mesh_.insert(middle, Triangulation::EDGE, face, edge);
    v->info().steiner = true;
    queue(a, v);
    queue(v, b);

    // Only triangles around the new vertex have changed.
    auto around = mesh_.incident_faces(v), first = around;
    do {
      const int opposite = around->index(v);
      if (!mesh_.is_infinite(around) && around->is_constrained(opposite)) {
        queue(around->vertex(Triangulation::ccw(opposite)), around->vertex(Triangulation::cw(opposite)));
      }
    } while (++around != first);
  }

  Triangulation& mesh_;
  double shortest_;
  std::vector<std::pair<Vertex, Vertex>> waiting_;
  EdgeSet whole_;
};

}  // namespace

void PlaneTriangulation::conform(double shortest) {
  Conformer conformer(data_->mesh, shortest);
  for (const Data::Kept& kept : data_->constraint) {
    if (!kept.id.vl_ptr()) continue;
    auto v = data_->mesh.vertices_in_constraint_begin(kept.id);
    for (Vertex last = *v++; v != data_->mesh.vertices_in_constraint_end(kept.id); last = *v++) {
      if (kept.divisible)
        conformer.queue(last, *v);
      else
        conformer.keep_whole(last, *v);
    }
  }
  conformer.run();
  data_->number_new_vertices();
}

}  // namespace pomona
