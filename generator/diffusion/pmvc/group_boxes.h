// Boxes around the groups of triangles, in the order in which a sweep visits them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "generator/diffusion/pmvc/aligned_array.h"
#include "generator/diffusion/pmvc/packed_surfaces.h"

namespace pomona {

/// All normalised, one entry per group, nearest to any point first. Padded to a multiple of TriangleGroup::size
/// with boxes around nothing, beyond everything.
struct GroupBoxes {
  std::array<AlignedFloats, 3> middle, half;  ///< x, y, z each
  std::vector<std::uint32_t> group;           ///< index into PackedSurfaces::groups
};

/// `points` are normalised and in an order that keeps neighbours together.
GroupBoxes nearest_first(const PackedSurfaces& surfaces, std::span<const glm::vec3> points);

}  // namespace pomona
