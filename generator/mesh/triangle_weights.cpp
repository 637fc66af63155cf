#include "generator/mesh/triangle_weights.h"

#include <algorithm>
#include <cstddef>

#include <glm/geometric.hpp>

namespace pomona {

std::array<double, 3> weights_in(const std::array<glm::dvec3, 3>& corner, const glm::dvec3& point) {
  const glm::dvec3 normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
  const double area = glm::dot(normal, normal);
  if (!(area > 0)) return {1, 0, 0};
  std::array<double, 3> weights{};
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 &a = corner[(i + 1) % 3], &b = corner[(i + 2) % 3];
    weights[i] = std::clamp(glm::dot(glm::cross(b - a, point - a), normal) / area, 0.0, 1.0);
    sum += weights[i];
  }
  for (double& w : weights) w /= sum;
  return weights;
}

}  // namespace pomona
