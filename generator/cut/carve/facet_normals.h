// Normals within a triangle of an arrangement.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/cut/carve/arrangement.h"

namespace pomona {

/// The distance from a as a share of that from a to b.
double share_between(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& point);

/// The normal at a point of the facet, from those at its corners. On an edge it depends, to the bit, only on the
/// normals at the ends of the edge. So two triangles with equal normals there have equal normals along the edge.
glm::vec3 normal_at(std::uint32_t place, const Arrangement::Facet& facet, const std::array<glm::dvec3, 3>& normal,
                    std::span<const glm::dvec3> points);

}  // namespace pomona
