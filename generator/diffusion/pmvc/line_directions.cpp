#include "generator/diffusion/pmvc/line_directions.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona {

Line line_along(const glm::dvec3& along) {
  const double sign = along.z < 0 ? -1 : 1;
  const double a = -1 / (sign + along.z);
  const double b = along.x * along.y * a;
  const glm::dvec3 u(1 + sign * along.x * along.x * a, sign * b, -sign * along.x);
  const glm::dvec3 v(b, sign + along.y * along.y * a, -along.y);
  return {glm::vec3(u), glm::vec3(v), glm::vec3(along)};
}

std::vector<Line> line_directions(int count) {
  // A spiral around a pole away from the axes, because fruit and knives lie along these.
  const glm::dvec3 pole = glm::normalize(glm::dvec3(0.536, 0.371, 0.758));
  const glm::dvec3 side = glm::normalize(glm::cross(pole, glm::dvec3(0.1, 0.9, 0.2)));
  const glm::dvec3 other = glm::cross(pole, side);

  const double golden_angle = pi * (3 - std::sqrt(5.0));
  std::vector<Line> lines;
  for (int i = 0; i < count; ++i) {
    const double z = (i + 0.5) / count;
    const double radius = std::sqrt(1 - z * z);
    const double angle = golden_angle * i;
    lines.push_back(
        line_along(z * pole + radius * (reproducible::cos(angle) * side + reproducible::sin(angle) * other)));
  }
  return lines;
}

}  // namespace pomona
