#include "render/strokes/seen_solid.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace pomona {

SeenSolid seen_solid(const Solid& solid, const Pose& pose, const Lens& lens) {
  SeenSolid seen{.vertex = {}, .facing = {}, .turn = glm::mat3_cast(pose.rotation), .at = pose.translation};
  seen.vertex.reserve(solid.mesh.position.size());
  seen.facing.reserve(solid.mesh.position.size());
  for (std::size_t v = 0; v < solid.mesh.position.size(); ++v) {
    const glm::dvec3 point = seen.in_scene(solid.mesh.position[v]);
    const glm::dvec3 normal = seen.turn * glm::dvec3(solid.mesh.normal[v]);
    seen.vertex.push_back(lens.seen(point));
    seen.facing.push_back(static_cast<float>(glm::dot(normal, glm::normalize(lens.eye() - point))));
  }
  return seen;
}

void visit_seen_solids(const Scene& scene, const Lens& lens, Threads threads,
                       const std::function<void(std::size_t first, std::span<const SeenSolid> seen)>& visit) {
  constexpr std::size_t vertices_at_once = 1 << 20;  // 28 bytes each
  const auto solid_of = [&](std::size_t instance) -> const Solid& {
    return scene.solids[static_cast<std::size_t>(scene.instances[instance].solid)];
  };
  for (std::size_t first = 0, end = 0; first < scene.instances.size(); first = end) {
    std::size_t vertices = 0;
    while (end < scene.instances.size() && (end == first || vertices < vertices_at_once))
      vertices += solid_of(end++).mesh.position.size();
    std::vector<SeenSolid> seen(end - first);
    parallel_for(seen.size(), threads, [&](std::size_t i) {
      seen[i] = seen_solid(solid_of(first + i), scene.instances[first + i].pose, lens);
    });
    visit(first, seen);
  }
}

}  // namespace pomona
