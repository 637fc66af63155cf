#include "generator/knife/knife_mesh.h"

#include <algorithm>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/knife/crease.h"
#include "generator/mesh/disjoint_sets.h"
#include "generator/mesh/edge_map.h"
#include "generator/mesh/edges.h"
#include "generator/mesh/weld.h"

namespace pomona {

namespace {

using Triangle = KnifeMesh::Triangle;

constexpr std::array<std::size_t, 3> next{1, 2, 0}, after_next{2, 0, 1};

glm::dvec3 unit(const glm::dvec3& v) {
  const double size = glm::length(v);
  return size > 0 ? v / size : glm::dvec3(0);
}

class MeshBuilder {
 public:
  explicit MeshBuilder(const ClosedSurface& surface) { take(surface); }

  /// True if triangles run along every edge equally often in both directions.
  bool is_closed() const {
    std::vector<glm::uvec3> triangles;
    for (const Triangle& t : mesh_.triangle) triangles.emplace_back(t.corner[0], t.corner[1], t.corner[2]);
    return pomona::is_closed(triangles);
  }

  KnifeMesh build() {
    find_smooth_edges();
    find_faces();
    find_normals();
    return std::move(mesh_);
  }

 private:
  void take(const ClosedSurface& surface) {
    // Merges points at equal places.
    const std::vector<std::uint32_t> first = weld(surface.point);
    std::vector<std::uint32_t> number(first.size());
    for (std::size_t p = 0; p < first.size(); ++p) {
      number[p] = first[p] == p ? static_cast<std::uint32_t>(mesh_.point.size()) : number[first[p]];
      if (first[p] == p) mesh_.point.push_back(surface.point[p]);
    }

    // Leaves out triangles that thereby lose a corner: they have no area, and their neighbours close the gap.
    for (const glm::uvec3& t : surface.triangle) {
      Triangle triangle;
      triangle.corner = {number[t.x], number[t.y], number[t.z]};
      const auto& c = triangle.corner;
      if (c[0] != c[1] && c[1] != c[2] && c[2] != c[0]) mesh_.triangle.push_back(triangle);
    }
  }

  /// The outward normal of the triangle, of twice its area.
  glm::dvec3 area_vector(std::size_t t) const {
    const std::array<glm::dvec3, 3> c = mesh_.corners(t);
    return glm::cross(c[1] - c[0], c[2] - c[0]);
  }

  /// Edges at which two triangles meet without a crease. Where more than two meet, the first is paired with each other.
  void find_smooth_edges() {
    for (std::size_t t = 0; t < mesh_.triangle.size(); ++t) normal_.push_back(unit(area_vector(t)));
    EdgeMap<Side> first_at;
    for (std::uint32_t t = 0; t < mesh_.triangle.size(); ++t) {
      const auto& c = mesh_.triangle[t].corner;
      for (std::uint32_t i = 0; i < 3; ++i) {
        const auto [other, is_new] = first_at.try_emplace({c[i], c[next[i]]}, Side{t, i});
        if (is_new) continue;
        if (glm::dot(normal_[t], normal_[other.triangle]) > smooth_cosine) smooth_.push_back({{t, i}, other});
      }
    }
  }

  /// Triangles that smooth edges join, directly or through others, become one face; faces are numbered in the order of
  /// their first triangles.
  void find_faces() {
    DisjointSets sets(mesh_.triangle.size());
    for (const auto& [a, b] : smooth_) sets.join(a.triangle, b.triangle);
    std::map<std::uint32_t, std::uint32_t> face_of;
    for (std::uint32_t t = 0; t < mesh_.triangle.size(); ++t) {
      mesh_.triangle[t].face = face_of.try_emplace(sets.root(t), mesh_.faces).first->second;
      mesh_.faces = static_cast<std::uint32_t>(face_of.size());
    }
  }

  /// One normal for all corners that are connected around a point without a crease between them. Each triangle counts
  /// by the angle it has there, so that the normal does not depend on how a face was cut into triangles.
  void find_normals() {
    // Join the corners at both ends of every smooth edge.
    DisjointSets corners(3 * mesh_.triangle.size());
    const auto corner_at = [&](std::uint32_t triangle, std::uint32_t point) {
      const auto& c = mesh_.triangle[triangle].corner;
      return 3 * triangle + static_cast<std::uint32_t>(std::find(c.begin(), c.end(), point) - c.begin());
    };
    for (const auto& [a, b] : smooth_) {
      for (const std::size_t end : {std::size_t{a.edge}, next[a.edge]}) {
        const std::uint32_t point = mesh_.triangle[a.triangle].corner[end];
        corners.join(corner_at(a.triangle, point), corner_at(b.triangle, point));
      }
    }

    // Sum the triangles' normals over joined corners, weighted by the angle's versine in place of the angle: the
    // versine needs no function that differs between processors.
    std::vector<glm::dvec3> sum(corners.count(), glm::dvec3(0));
    for (std::uint32_t t = 0; t < mesh_.triangle.size(); ++t) {
      const std::array<glm::dvec3, 3> c = mesh_.corners(t);
      for (std::uint32_t i = 0; i < 3; ++i) {
        const glm::dvec3 a = unit(c[next[i]] - c[i]), b = unit(c[after_next[i]] - c[i]);
        sum[corners.root(3 * t + i)] += normal_[t] * (1 - glm::dot(a, b));
      }
    }

    for (std::uint32_t t = 0; t < mesh_.triangle.size(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) mesh_.triangle[t].normal[i] = unit(sum[corners.root(3 * t + i)]);
    }
  }

  struct Side {
    std::uint32_t triangle = 0, edge = 0;
  };
  std::vector<glm::dvec3> normal_;             // per triangle
  std::vector<std::pair<Side, Side>> smooth_;  // edges that are no creases, with their two triangles
  KnifeMesh mesh_;
};

/// Halves edges that are too long. Where an edge of a triangle is halved its longest is halved, too, so that triangles
/// never get much thinner than they were [Rivara 1984].
class Refiner {
 public:
  Refiner(KnifeMesh& mesh, const std::function<double(const glm::dvec3&)>& size) : mesh_(mesh), size_(size) {}

  /// Halves all edges that are too long, once. False if there were none.
  bool halve() {
    // Marks the edges that are too long, and those that must be halved with them.
    middle_of_.clear();
    for (const Triangle& t : mesh_.triangle) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (is_too_long(t.corner[i], t.corner[next[i]])) mark(t.corner[i], t.corner[next[i]]);
      }
    }
    if (middle_of_.empty()) return false;
    mark_longest();

    // Splits all triangles at their marked edges.
    std::vector<Triangle> whole;
    whole.swap(mesh_.triangle);
    for (const Triangle& t : whole) split(t);
    return true;
  }

 private:
  double length(std::uint32_t a, std::uint32_t b) const { return glm::distance(mesh_.point[a], mesh_.point[b]); }

  bool is_too_long(std::uint32_t a, std::uint32_t b) {
    const auto [too_long, is_new] = known_.try_emplace({a, b}, false);
    if (is_new) too_long = length(a, b) > 1.4 * size_(0.5 * (mesh_.point[a] + mesh_.point[b]));
    return too_long;
  }

  /// Gives an edge a point in its middle, unless it has one.
  void mark(std::uint32_t a, std::uint32_t b) {
    const auto number = static_cast<std::uint32_t>(mesh_.point.size());
    if (middle_of_.try_emplace({a, b}, number).is_new) mesh_.point.push_back(0.5 * (mesh_.point[a] + mesh_.point[b]));
  }

  bool is_marked(const Triangle& t, std::size_t i) const {
    return middle_of_.contains({t.corner[i], t.corner[next[i]]});
  }

  /// The triangle's longest edge. Ties are broken by the edge's ends, so that both triangles at an edge agree.
  std::size_t longest(const Triangle& t) const {
    std::size_t best = 0;
    const auto order = [&](std::size_t i) {
      return std::pair(length(t.corner[i], t.corner[next[i]]), EdgeKey(t.corner[i], t.corner[next[i]]));
    };
    for (std::size_t i = 1; i < 3; ++i) {
      if (order(i) > order(best)) best = i;
    }
    return best;
  }

  /// Marks the longest edge of each triangle that has a marked one, until no more are marked.
  void mark_longest() {
    for (bool changed = true; changed;) {
      changed = false;
      for (const Triangle& t : mesh_.triangle) {
        if (!is_marked(t, 0) && !is_marked(t, 1) && !is_marked(t, 2)) continue;
        const std::size_t i = longest(t);
        if (is_marked(t, i)) continue;
        mark(t.corner[i], t.corner[next[i]]);
        changed = true;
      }
    }
  }

  /// Cuts a triangle in two at its longest marked edge, the halves at other marked edges, and adds the results to the
  /// mesh.
  void split(const Triangle& t) {
    // Picks the longest edge. In half a triangle it may not be marked; then picks the first marked edge.
    std::size_t i = longest(t);
    if (!is_marked(t, i)) {
      i = 0;
      while (i < 3 && !is_marked(t, i)) ++i;
      if (i == 3) {
        mesh_.triangle.push_back(t);
        return;
      }
    }

    // The new corner's normal is that of the edge's middle.
    const std::size_t j = next[i], k = after_next[i];
    const std::uint32_t middle = middle_of_.at({t.corner[i], t.corner[j]});
    const glm::dvec3 normal = unit(t.normal[i] + t.normal[j]);
    split({{t.corner[i], middle, t.corner[k]}, {t.normal[i], normal, t.normal[k]}, t.face});
    split({{middle, t.corner[j], t.corner[k]}, {normal, t.normal[j], t.normal[k]}, t.face});
  }

  KnifeMesh& mesh_;
  const std::function<double(const glm::dvec3&)>& size_;
  EdgeMap<bool> known_;               // whether it is too long
  EdgeMap<std::uint32_t> middle_of_;  // per marked edge: the point in its middle
};

}  // namespace

KnifeMesh knife_mesh(const ClosedSurface& surface, const std::string& name) {
  for (const glm::uvec3& t : surface.triangle) {
    for (int i = 0; i < 3; ++i) {
      if (t[i] >= surface.point.size()) throw Error(ExitStatus::bad_data, "knife \"" + name + "\" lacks points");
    }
  }
  MeshBuilder builder(surface);
  if (!builder.is_closed()) throw Error(ExitStatus::bad_data, "knife \"" + name + "\" is no closed surface");
  return builder.build();
}

KnifeMesh refined(KnifeMesh mesh, const std::function<double(const glm::dvec3&)>& size) {
  Refiner refiner(mesh, size);
  while (refiner.halve()) {
  }
  return mesh;
}

}  // namespace pomona
