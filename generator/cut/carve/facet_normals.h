// Normals within a triangle of an arrangement.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/cut/carve/arrangement.h"

namespace pomona {

/// Of a point between the corners of a triangle: how much each counts; adds up to 1.
std::array<double, 3> weights_in(const std::array<glm::dvec3, 3>& corner, const glm::dvec3& point);

/// The distance from a as a share of that from a to b.
double share_between(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& point);

/// The normal at a place on the facet, from those at its corners. On an edge it depends on what the edge has at its
/// ends alone, to the bit: triangles that agree there agree along it.
glm::vec3 normal_at(std::uint32_t place, const Arrangement::Facet& facet, const std::array<glm::dvec3, 3>& normal,
                    std::span<const glm::dvec3> points);

}  // namespace pomona
