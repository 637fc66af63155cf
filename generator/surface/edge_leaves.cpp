#include "generator/surface/edge_leaves.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona {

bool at_one_angle(const EdgeLeaf& a, const EdgeLeaf& b) {
  constexpr double same_angle = 1e-6;
  const double apart = std::fabs(b.angle - a.angle);
  return std::min(apart, 2 * pi - apart) <= same_angle;
}

std::vector<EdgeLeaf> leaves_around(std::span<const HalfEdge> edge, std::span<const glm::uvec3> triangles,
                                    std::span<const glm::vec3> position) {
  const glm::dvec3 low(position[edge.front().low]);
  const glm::dvec3 along = glm::normalize(glm::dvec3(position[edge.front().high]) - low);
  glm::dvec3 zero_angle(0);
  std::vector<EdgeLeaf> leaves;
  for (const HalfEdge& h : edge) {
    const glm::uvec3& t = triangles[h.triangle];
    const std::uint32_t tip = t.x + t.y + t.z - h.low - h.high;
    const glm::dvec3 to_tip = glm::dvec3(position[tip]) - low;
    const glm::dvec3 across = to_tip - glm::dot(to_tip, along) * along;
    if (leaves.empty()) zero_angle = across;
    const double y = glm::dot(glm::cross(zero_angle, across), along);
    leaves.push_back({reproducible::atan2(y, glm::dot(zero_angle, across)), h.forward, h.triangle});
  }
  std::sort(leaves.begin(), leaves.end(), [](const EdgeLeaf& l, const EdgeLeaf& r) {
    return std::tuple(l.angle, !l.forward, l.triangle) < std::tuple(r.angle, !r.forward, r.triangle);
  });
  return leaves;
}

}  // namespace pomona
