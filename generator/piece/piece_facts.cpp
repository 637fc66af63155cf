#include "generator/piece/piece_facts.h"

#include <glm/common.hpp>

namespace pomona {

PieceFacts facts_of(const Solid& solid) {
  PieceFacts facts;
  facts.triangles = solid.mesh.triangle.size();
  facts.volume = solid.volume;
  facts.density = solid.density;
  facts.mass = solid.density * solid.volume;
  if (solid.mesh.position.empty()) return facts;
  facts.low = facts.high = glm::dvec3(solid.mesh.position.front());
  for (const glm::vec3& p : solid.mesh.position) {
    facts.low = glm::min(facts.low, glm::dvec3(p));
    facts.high = glm::max(facts.high, glm::dvec3(p));
  }
  facts.center = 0.5 * (facts.low + facts.high);

  // Relative to the middle of the box, so that thin pieces far from the origin keep their digits.
  const Moments moments = moments_of(solid.mesh.position, solid.mesh.triangle, facts.center);
  const glm::dvec3 box = facts.high - facts.low;
  if (!solid.closed || !(6 * moments.mass > 1e-9 * box.x * box.y * box.z)) return facts;
  const RigidMass rigid = solid.weighed ? *solid.weighed : rigid_mass(moments, facts.center);
  facts.center = rigid.center;
  facts.inertia = solid.weighed ? rigid.inertia : solid.density * rigid.inertia;
  if (solid.weighed) {
    facts.mass = rigid.mass;
    facts.density = rigid.mass / solid.volume;
  }
  return facts;
}

}  // namespace pomona
