// The Morton curve: numbers that keep neighbours in space near each other in order.
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace pomona {

/// The place of a point along the curve through the box from `low` to `high`, 21 bits an axis.
std::uint64_t morton_code(const glm::dvec3& point, const glm::dvec3& low, const glm::dvec3& high);

}  // namespace pomona
