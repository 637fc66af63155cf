#include "render/strokes/seen_solid.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace pomona {

SeenSolid seen_solid(const Solid& solid, const Pose& pose, const Lens& lens) {
  SeenSolid seen{.vertex = {}, .facing = {}, .turn = glm::mat3_cast(pose.rotation), .at = pose.translation};
  seen.vertex.reserve(solid.position.size());
  seen.facing.reserve(solid.position.size());
  for (std::size_t v = 0; v < solid.position.size(); ++v) {
    const glm::dvec3 point = seen.in_scene(solid.position[v]);
    const glm::dvec3 normal = seen.turn * glm::dvec3(solid.normal[v]);
    seen.vertex.push_back(lens.seen(point));
    seen.facing.push_back(static_cast<float>(glm::dot(normal, glm::normalize(lens.eye() - point))));
  }
  return seen;
}

}  // namespace pomona
