#include "render/texture/triangle_neighbors.h"

#include <span>

#include "generator/mesh/edges.h"
#include "generator/mesh/weld.h"

namespace pomona {

TriangleNeighbors triangle_neighbors(const Solid& solid) {
  TriangleNeighbors found;
  found.place_of = weld(solid.mesh.position);
  found.neighbor.assign(solid.mesh.triangle.size(), {-1, -1, -1});

  const std::vector<glm::uvec3> triangles = welded_triangles(found.place_of, solid.mesh.triangle);
  const HalfEdgeOptions options{.kind = solid.mesh.cut_face, .of_collapsed = true};
  for_each_edge(sorted_half_edges(triangles, options), [&](std::span<const HalfEdge> edge) {
    if (edge.size() != 2) return;
    const HalfEdge &a = edge[0], &b = edge[1];
    found.neighbor[a.triangle][a.side] = static_cast<std::int32_t>(b.triangle);
    found.neighbor[b.triangle][b.side] = static_cast<std::int32_t>(a.triangle);
  });
  return found;
}

}  // namespace pomona
