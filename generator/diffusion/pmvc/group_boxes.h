// Boxes around the groups of triangles, in the order in which a sweep visits them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "generator/diffusion/pmvc/aligned_array.h"
#include "generator/diffusion/pmvc/packed_surfaces.h"

namespace pomona {

/// Normalised boxes, one per group, nearest to any point first, padded to a multiple of TriangleGroup::size with empty
/// boxes far away.
struct GroupBoxes {
  std::array<AlignedFloats, 3> middle, half;  ///< x, y, z each
  std::vector<std::uint32_t> group;           ///< index into PackedSurfaces::groups
};

/// `points` are normalised, with neighbours next to each other.
GroupBoxes nearest_first(const PackedSurfaces& surfaces, std::span<const glm::vec3> points);

}  // namespace pomona
