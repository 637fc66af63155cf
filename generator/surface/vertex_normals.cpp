#include <glm/geometric.hpp>

#include "generator/mesh/weld.h"
#include "generator/surface/bodies.h"

namespace pomona {

std::vector<glm::vec3> vertex_normals(const DiffusionSurfaces& surfaces) {
  // Sum twice the area vectors where equal positions meet, in the triangles' order.
  const std::vector<std::uint32_t> first = weld(surfaces.position);
  std::vector<glm::dvec3> sum(surfaces.vertex_count(), glm::dvec3(0));
  for (const glm::uvec3& t : surfaces.triangle) {
    const glm::dvec3 a(surfaces.position[t.x]), b(surfaces.position[t.y]), c(surfaces.position[t.z]);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    for (int k = 0; k < 3; ++k) sum[first[t[k]]] += normal;
  }

  std::vector<glm::vec3> normals(surfaces.vertex_count(), glm::vec3(0));
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const glm::dvec3& n = sum[first[v]];
    const double size = glm::length(n);
    if (size > 0) normals[v] = glm::vec3(n / size);
  }
  return normals;
}

}  // namespace pomona
