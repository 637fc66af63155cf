// The Morton curve: an order that keeps neighbours in space near each other.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace pomona {

/// The place of a point along the curve through the box from `low` to `high`, 21 bits an axis.
std::uint64_t morton_code(const glm::dvec3& point, const glm::dvec3& low, const glm::dvec3& high);

/// The order of finite points along a Morton curve through the box around them, in steps of 1/1024 of it; points in
/// the same step keep their order.
std::vector<std::uint32_t> morton_order(std::span<const glm::dvec3> points);

}  // namespace pomona
