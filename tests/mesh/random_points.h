// Random points for tests of geometry.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace pomona {

/// Points evenly spread over the cube from -size to size; each seed gives other points.
std::vector<glm::dvec3> random_points(std::size_t count, double size, std::uint64_t seed = 1);

}  // namespace pomona
