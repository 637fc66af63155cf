#include "render/export/collision/solid_bodies.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <tuple>

#include "generator/mesh/disjoint_sets.h"
#include "generator/mesh/weld.h"

namespace pomona::collision {

namespace {

/// A triangle's edge, from its smaller to its larger vertex.
struct TriangleEdge {
  std::uint32_t low = 0, high = 0;                 ///< after welding
  std::array<std::uint32_t, 2> own_vertices = {};  ///< before, in the same order
  std::uint32_t triangle = 0;
  bool forward = false;  ///< the triangle runs from low to high
};

/// Sorted, those between the same vertices one after the other.
std::vector<TriangleEdge> edges_of(const SolidMesh& mesh) {
  const std::vector<glm::uvec3> triangles = welded_triangles(weld(mesh.position), mesh.triangle);
  std::vector<TriangleEdge> edges;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      const std::uint32_t a = triangles[t][k], b = triangles[t][next];
      const std::uint32_t own_a = mesh.triangle[t][k], own_b = mesh.triangle[t][next];
      if (a < b) edges.push_back({a, b, {own_a, own_b}, t, true});
      if (a > b) edges.push_back({b, a, {own_b, own_a}, t, false});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const TriangleEdge& a, const TriangleEdge& b) {
    return std::tie(a.low, a.high, a.own_vertices, a.triangle) < std::tie(b.low, b.high, b.own_vertices, b.triangle);
  });
  return edges;
}

/// Calls take(first, end) for the edges between each two vertices.
template <class Take>
void for_each_edge(const std::vector<TriangleEdge>& edges, const Take& take) {
  for (auto first = edges.begin(), end = first; first != edges.end(); first = end) {
    end = std::find_if(first, edges.end(),
                       [&](const TriangleEdge& e) { return e.low != first->low || e.high != first->high; });
    take(first, end);
  }
}

/// Sets of triangles that share edges of two; where bodies touch along an edge, those of two with the same vertices.
DisjointSets joined_by(const std::vector<TriangleEdge>& edges, std::size_t triangles) {
  DisjointSets sets(triangles);
  for_each_edge(edges, [&](auto first, auto end) {
    for (auto one = first, next = first; one != end; one = next) {
      next = std::find_if(one, end, [&](const TriangleEdge& e) { return e.own_vertices != one->own_vertices; });
      if (end - first == 2) next = end;
      if (next - one == 2) sets.join(one->triangle, std::next(one)->triangle);
    }
  });
  return sets;
}

/// At each edge, as many triangles of a set run one way as the other.
bool all_are_closed(const std::vector<TriangleEdge>& edges, DisjointSets& sets) {
  bool closed = true;
  for_each_edge(edges, [&](auto first, auto end) {
    for (auto one = first; closed && one != end; ++one) {
      int sum = 0;
      for (auto other = first; other != end; ++other)
        if (sets.root(other->triangle) == sets.root(one->triangle)) sum += other->forward ? 1 : -1;
      closed = sum == 0;
    }
  });
  return closed;
}

}  // namespace

std::vector<CutSurface> bodies_of(const Solid& solid) {
  const SolidMesh& mesh = solid.mesh;
  const std::vector<TriangleEdge> edges = edges_of(mesh);
  DisjointSets sets = joined_by(edges, mesh.triangle.size());
  const std::size_t none = mesh.triangle.size();
  std::vector<std::size_t> number(mesh.triangle.size(), none);
  std::vector<CutSurface> bodies;
  CutSurface all;
  for (std::uint32_t t = 0; t < mesh.triangle.size(); ++t) {
    std::size_t& body = number[sets.root(t)];
    if (body == none) body = bodies.size(), bodies.emplace_back();
    bodies[body].skin.push_back(mesh.corners(t));
    all.skin.push_back(mesh.corners(t));
  }
  const bool all_are_solid =
      std::all_of(bodies.begin(), bodies.end(), [](const CutSurface& body) { return body.volume() > 0; });
  if (all_are_solid && all_are_closed(edges, sets)) return bodies;
  return {std::move(all)};
}

}  // namespace pomona::collision
