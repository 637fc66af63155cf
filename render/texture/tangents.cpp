#include "render/texture/tangents.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

/// Any direction at right angles to a normal.
glm::dvec3 across(const glm::dvec3& normal) {
  const glm::dvec3 aside = std::fabs(normal.y) < 0.8 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  return glm::cross(aside, normal);
}

}  // namespace

std::vector<glm::vec4> tangents(std::span<const glm::vec3> position, std::span<const glm::vec3> normal,
                                std::span<const glm::vec2> uv, std::span<const glm::uvec3> triangle) {
  std::vector<glm::dvec3> sum(position.size(), glm::dvec3(0));
  for (const glm::uvec3& t : triangle) {
    const glm::dvec3 a(position[t.x]), first = glm::dvec3(position[t.y]) - a, second = glm::dvec3(position[t.z]) - a;
    const glm::dvec2 p(uv[t.x]), q = glm::dvec2(uv[t.y]) - p, r = glm::dvec2(uv[t.z]) - p;
    const double turn = q.x * r.y - r.x * q.y;
    if (turn == 0) continue;
    const glm::dvec3 along = (first * r.y - second * q.y) / turn, crossed = glm::cross(first, second);
    const double length = std::sqrt(glm::dot(along, along)), area = std::sqrt(glm::dot(crossed, crossed));
    if (!(length > 0)) continue;
    for (int k = 0; k < 3; ++k) sum[t[k]] += along * (area / length);
  }
  std::vector<glm::vec4> made(position.size());
  for (std::size_t v = 0; v < made.size(); ++v) {
    const glm::dvec3 up(normal[v]);
    glm::dvec3 along = sum[v] - up * (glm::dot(sum[v], up) / glm::dot(up, up));
    if (!(glm::dot(along, along) > 1e-24)) along = across(up);
    made[v] = glm::vec4(glm::vec3(along / std::sqrt(glm::dot(along, along))), 1.0f);
  }
  return made;
}

}  // namespace pomona
