#include "generator/diffusion/walk/walk_draws.h"

#include <cmath>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pomona {

Draws::InDisc Draws::in_disc() {
  // Two coordinates of 32 bits from one random number.
  while (true) {
    const std::uint64_t bits = stream_.bits(next_++);
    const double x = (static_cast<double>(bits >> 32) + 0.5) * 0x1p-31 - 1;
    const double y = (static_cast<double>(bits & 0xffffffff) + 0.5) * 0x1p-31 - 1;
    const double squared = x * x + y * y;
    if (squared < 1) return {x, y, squared};
  }
}

glm::dvec3 random_direction(Draws& draws) {
  const Draws::InDisc p = draws.in_disc();
  const double stretch = 2 * std::sqrt(1 - p.squared);
  return {stretch * p.x, stretch * p.y, 1 - 2 * p.squared};
}

std::array<glm::dvec3, 12> random_icosahedron(Draws& draws) {
  // A random rotation as a unit quaternion [Marsaglia 1972], and the columns of its matrix.
  const Draws::InDisc p = draws.in_disc(), q = draws.in_disc();
  const double stretch = std::sqrt((1 - p.squared) / q.squared);
  const double a = p.x, b = p.y, c = stretch * q.x, d = stretch * q.y;
  const glm::dvec3 x(1 - 2 * (c * c + d * d), 2 * (b * c + a * d), 2 * (b * d - a * c));
  const glm::dvec3 y(2 * (b * c - a * d), 1 - 2 * (b * b + d * d), 2 * (c * d + a * b));
  const glm::dvec3 z = glm::cross(x, y);

  // The corners are (0, +-1, +-golden ratio) and its cyclic changes.
  const double golden = 0.5 * (1 + std::sqrt(5.0)), per_length = 1 / std::sqrt(1 + golden * golden);
  const double small = per_length, large = golden * per_length;
  std::array<glm::dvec3, 12> corner;
  std::size_t n = 0;
  for (const double s : {small, -small}) {
    for (const double l : {large, -large}) {
      corner[n++] = s * y + l * z;
      corner[n++] = s * z + l * x;
      corner[n++] = s * x + l * y;
    }
  }
  return corner;
}

glm::dvec3 random_return(const glm::dvec3& outside, double radius, Draws& draws) {
  // The cosine of the angle at the middle, by inverting the Poisson kernel's distribution; written so that nothing
  // cancels where `outside` is far away (ratio 0, uniform) or on the sphere (ratio 1, stays there).
  const double distance = glm::length(outside), ratio = radius / distance, u = 2 * draws.uniform() - 1;
  const double numerator = u + ratio * (0.5 * (3 + u * u) + ratio * (u + ratio * 0.5 * (u * u - 1)));
  const double cosine = glm::clamp(numerator / ((1 + ratio * u) * (1 + ratio * u)), -1.0, 1.0);

  // A uniform direction around the axis.
  const glm::dvec3 axis = outside / distance;
  const glm::dvec3 min = std::fabs(axis.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 side = glm::normalize(glm::cross(axis, min)), other = glm::cross(axis, side);
  const Draws::InDisc p = draws.in_disc();
  const double sine = std::sqrt((1 - cosine * cosine) / p.squared);
  return radius * (cosine * axis + sine * p.x * side + sine * p.y * other);
}

}  // namespace pomona
