#include "generator/cut/carve/facet_normals.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/mesh/triangle_weights.h"

namespace pomona {

double share_between(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& point) {
  return std::min(1.0, glm::distance(a, point) / glm::distance(a, b));
}

glm::vec3 normal_at(std::uint32_t place, const Arrangement::Facet& facet, const std::array<glm::dvec3, 3>& normal,
                    std::span<const glm::dvec3> points) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (facet.corner[i] == place) return glm::vec3(normal[i]);
  }
  glm::dvec3 sum(0);
  for (std::size_t i = 0; i < 3 && sum == glm::dvec3(0); ++i) {
    const std::vector<std::uint32_t>& chain = facet.mesh.chain[i];
    if (std::find(chain.begin(), chain.end(), place) == chain.end()) continue;
    std::size_t a = i, b = (i + 1) % 3;
    if (facet.corner[a] > facet.corner[b]) std::swap(a, b);
    sum =
        glm::mix(normal[a], normal[b], share_between(points[facet.corner[a]], points[facet.corner[b]], points[place]));
  }
  if (sum == glm::dvec3(0)) {
    const std::array<double, 3> weight =
        weights_in({points[facet.corner[0]], points[facet.corner[1]], points[facet.corner[2]]}, points[place]);
    for (std::size_t i = 0; i < 3; ++i) sum += weight[i] * normal[i];
  }
  const double size = glm::length(sum);
  return glm::vec3(size > 0 ? sum / size : normal[0]);
}

}  // namespace pomona
