#include "render/texture/triangle_neighbors.h"

#include <algorithm>
#include <tuple>

#include "generator/mesh/welded_edges.h"

namespace pomona {

namespace {

/// A triangle's edge, named by its places.
struct EdgeOfKind {
  std::int32_t cut_face = -1;
  std::uint32_t low = 0, high = 0;
  std::uint32_t triangle = 0, edge = 0;
  bool operator<(const EdgeOfKind& o) const {
    return std::tie(cut_face, low, high, triangle, edge) < std::tie(o.cut_face, o.low, o.high, o.triangle, o.edge);
  }
  bool is_same_edge(const EdgeOfKind& o) const { return cut_face == o.cut_face && low == o.low && high == o.high; }
};

}  // namespace

TriangleNeighbors triangle_neighbors(const Solid& solid) {
  TriangleNeighbors found;
  found.place_of = weld(solid.position);
  found.neighbor.assign(solid.triangle.size(), {-1, -1, -1});

  std::vector<EdgeOfKind> edges;
  for (std::uint32_t t = 0; t < solid.triangle.size(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t a = found.place_of[solid.triangle[t][i]], b = found.place_of[solid.triangle[t][(i + 1) % 3]];
      if (a != b) edges.push_back({solid.cut_face[t], std::min(a, b), std::max(a, b), t, i});
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i;
    while (end < edges.size() && edges[end].is_same_edge(edges[i])) ++end;
    if (end - i == 2) {
      const EdgeOfKind &a = edges[i], &b = edges[i + 1];
      found.neighbor[a.triangle][a.edge] = static_cast<std::int32_t>(b.triangle);
      found.neighbor[b.triangle][b.edge] = static_cast<std::int32_t>(a.triangle);
    }
    i = end;
  }
  return found;
}

}  // namespace pomona
