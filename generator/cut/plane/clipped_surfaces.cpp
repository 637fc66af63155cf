#include "generator/cut/plane/clipped_surfaces.h"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pomona {

namespace {

/// Splits triangle after triangle.
class SurfaceClipper {
 public:
  SurfaceClipper(SplitMesh mesh, const std::vector<EdgePoint>& edge_points, const DiffusionSurfaces& surfaces)
      : mesh_(std::move(mesh)), edge_points_(edge_points), surfaces_(surfaces) {}

  ClippedSurfaces clip(bool inner_too) {
    for (const SplitMesh::Triangle& t : mesh_.triangle) {
      const bool is_boundary = surfaces_.is_boundary(t.source);
      if (!is_boundary && !inner_too) continue;
      SurfaceTriangle whole{t.vertex, t.source, t.cell};
      if (is_boundary && surfaces_.is_hidden(t.source, SideOf::back)) std::swap(whole.vertex[1], whole.vertex[2]);
      add(whole);
    }
    for (std::uint32_t& point : mesh_.point_of) point = mesh_.same_as[point];
    return {std::move(mesh_), std::move(clipped_)};
  }

 private:
  /// Makes a fan from the opposite corner over the points of one edge; points on other edges come next.
  void add(const SurfaceTriangle& t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t.vertex[i], b = t.vertex[(i + 1) % 3], c = t.vertex[(i + 2) % 3];
      const std::vector<std::uint32_t> between = vertices_between(a, b);
      if (between.empty()) continue;
      std::uint32_t last = a;
      for (const std::uint32_t v : between) {
        add({{last, v, c}, t.source, t.cell});
        last = v;
      }
      add({{last, b, c}, t.source, t.cell});
      return;
    }
    clipped_.push_back(t);
  }

  /// The vertices on the edge from a to b, in that order. Only edges of the split mesh have any.
  std::vector<std::uint32_t> vertices_between(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t p = mesh_.point_of[a], q = mesh_.point_of[b];
    if (p > q) {
      std::vector<std::uint32_t> turned = vertices_between(b, a);
      std::reverse(turned.begin(), turned.end());
      return turned;
    }
    std::vector<std::uint32_t> vertices;
    if (mesh_.planes_of[p] == 0 || mesh_.planes_of[q] == 0) return vertices;
    const auto first = std::lower_bound(edge_points_.begin(), edge_points_.end(), EdgePoint{p, q, 0, 0});
    for (auto e = first; e != edge_points_.end() && e->low == p && e->high == q; ++e) {
      vertices.push_back(vertex_at(a, b, *e));
    }
    return vertices;
  }

  std::uint32_t vertex_at(std::uint32_t a, std::uint32_t b, const EdgePoint& e) {
    const auto [entry, is_new] = made_.try_emplace({a, b, e.point}, static_cast<std::uint32_t>(mesh_.point_of.size()));
    if (!is_new) return entry->second;
    const auto share = static_cast<float>(e.share);
    const glm::vec3 normal = glm::mix(mesh_.normal[a], mesh_.normal[b], share);
    const float size = glm::length(normal);
    return mesh_.add_vertex(e.point, glm::mix(mesh_.front_color[a], mesh_.front_color[b], share),
                            glm::mix(mesh_.back_color[a], mesh_.back_color[b], share),
                            size > 0 ? normal / size : normal);
  }

  SplitMesh mesh_;
  const std::vector<EdgePoint>& edge_points_;  // sorted
  const DiffusionSurfaces& surfaces_;
  std::vector<SurfaceTriangle> clipped_;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> made_;
};

}  // namespace

ClippedSurfaces clipped_surfaces(SplitMesh mesh, const std::vector<EdgePoint>& edge_points,
                                 const DiffusionSurfaces& surfaces, const SurfaceClipOptions& options) {
  return SurfaceClipper(std::move(mesh), edge_points, surfaces).clip(options.inner_too);
}

}  // namespace pomona
