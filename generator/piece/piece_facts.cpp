#include "generator/piece/piece_facts.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pomona {

PieceFacts facts_of(const Solid& solid) {
  PieceFacts facts;
  facts.triangles = solid.triangle.size();
  facts.volume = solid.volume;
  facts.mass = solid.density * solid.volume;
  if (solid.position.empty()) return facts;
  facts.low = facts.high = glm::dvec3(solid.position.front());
  for (const glm::vec3& p : solid.position) {
    facts.low = glm::min(facts.low, glm::dvec3(p));
    facts.high = glm::max(facts.high, glm::dvec3(p));
  }
  facts.center = 0.5 * (facts.low + facts.high);

  // Tetrahedra from the middle of the box, so that thin pieces far from the origin keep their digits.
  const glm::dvec3 origin = facts.center;
  double volume = 0;
  glm::dvec3 moment(0);
  for (const glm::uvec3& t : solid.triangle) {
    const glm::dvec3 a = glm::dvec3(solid.position[t.x]) - origin, b = glm::dvec3(solid.position[t.y]) - origin,
                     c = glm::dvec3(solid.position[t.z]) - origin;
    const double six = glm::dot(a, glm::cross(b, c));
    volume += six;
    moment += six * 0.25 * (a + b + c);
  }
  const glm::dvec3 box = facts.high - facts.low;
  const bool is_solid = solid.closed && volume > 1e-9 * box.x * box.y * box.z;
  if (is_solid) facts.center = origin + moment / volume;
  return facts;
}

}  // namespace pomona
