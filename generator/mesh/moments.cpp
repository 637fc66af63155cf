#include "generator/mesh/moments.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace pomona {

void Moments::add(const Moments& more, double times) {
  mass += times * more.mass;
  first += times * more.first;
  second += times * more.second;
}

Moments moments_of(std::span<const glm::vec3> position, std::span<const glm::uvec3> triangle,
                   const glm::dvec3& origin) {
  Moments six;  // times the volume
  for (const glm::uvec3& t : triangle) {
    const glm::dvec3 a = glm::dvec3(position[t.x]) - origin, b = glm::dvec3(position[t.y]) - origin,
                     c = glm::dvec3(position[t.z]) - origin, sum = a + b + c;
    const double v = glm::dot(a, glm::cross(b, c));
    six.mass += v;
    six.first += v * 0.25 * sum;
    six.second +=
        (glm::outerProduct(a, a) + glm::outerProduct(b, b) + glm::outerProduct(c, c) + glm::outerProduct(sum, sum)) *
        (v / 20);
  }
  Moments moments;
  moments.add(six, 1.0 / 6);
  return moments;
}

RigidMass rigid_mass(const Moments& moments, const glm::dvec3& origin) {
  if (moments.mass == 0) return {0, origin, glm::dmat3(0)};
  const glm::dvec3 away = moments.first / moments.mass;
  const glm::dmat3 spread = moments.second - moments.mass * glm::outerProduct(away, away);
  return {moments.mass, origin + away, glm::dmat3(spread[0][0] + spread[1][1] + spread[2][2]) - spread};
}

}  // namespace pomona
