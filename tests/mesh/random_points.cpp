#include "tests/mesh/random_points.h"

#include "generator/base/random.h"

namespace pomona {

std::vector<glm::dvec3> random_points(std::size_t count, double size, std::uint64_t seed) {
  const RandomStream draw({seed, 0}, "tests/mesh");
  std::vector<glm::dvec3> points;
  for (std::uint64_t i = 0; i < count; ++i) {
    const glm::dvec3 unit(draw.uniform(3 * i), draw.uniform(3 * i + 1), draw.uniform(3 * i + 2));
    points.push_back(size * (2.0 * unit - 1.0));
  }
  return points;
}

}  // namespace pomona
