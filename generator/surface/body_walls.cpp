#include "generator/surface/body_walls.h"

#include <utility>
#include <vector>

namespace pomona {

Enclosures body_walls(const DiffusionSurfaces& surfaces, const Bodies& bodies) {
  std::vector<Enclosures::Triangle> walls;
  for (std::size_t t = 0; t < surfaces.triangle_count(); ++t) {
    if (!surfaces.is_boundary(t)) continue;
    const glm::uvec3& v = surfaces.triangle[t];
    const bool turned = surfaces.is_hidden(t, SideOf::back);
    walls.push_back({{glm::dvec3(surfaces.position[v.x]), glm::dvec3(surfaces.position[turned ? v.z : v.y]),
                      glm::dvec3(surfaces.position[turned ? v.y : v.z])},
                     static_cast<std::uint32_t>(bodies.of_triangle[t])});
  }
  return Enclosures(std::move(walls));
}

}  // namespace pomona
