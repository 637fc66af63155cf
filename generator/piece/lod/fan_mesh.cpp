#include "generator/piece/lod/fan_mesh.h"

namespace pomona {

FanMesh fan_mesh(const VertexFans& fans) {
  FanMesh mesh;
  mesh.twin = fans.twin;
  mesh.is_there.assign(fans.triangle.size(), 1);
  mesh.leave.assign(fans.vertex.size(), none);
  for (const glm::uvec3& t : fans.triangle) {
    for (std::uint32_t i = 0; i < 3; ++i)
      mesh.leave[t[static_cast<int>(i)]] = static_cast<std::uint32_t>(3 * mesh.corner.size() + i);
    mesh.corner.push_back({t.x, t.y, t.z});
  }
  mesh.is_open.assign(fans.vertex.size(), 0);
  for (std::uint32_t h = 0; h < mesh.twin.size(); ++h) {
    if (mesh.twin[h] == none) mesh.is_open[mesh.from(h)] = mesh.is_open[mesh.to(h)] = 1;
  }
  return mesh;
}

Ring ring_around(const FanMesh& mesh, std::uint32_t fan, Ring recycled) {
  Ring ring = std::move(recycled);
  ring.clear();
  for_each_spoke(mesh, fan, [&](const Spoke& spoke) { ring.push_back(spoke); });
  return ring;
}

}  // namespace pomona
