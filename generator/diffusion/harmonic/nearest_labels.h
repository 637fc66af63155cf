// For each node, the side of the surface that is nearest along open arms.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/diffusion/harmonic/grid_level.h"

namespace pomona {

/// Per stored node of a level: the side (2 * triangle, + 1 for its back) that is fewest open arms away; no_side if none
/// can be reached.
constexpr std::uint32_t no_side = 0xffffffffu;
std::vector<std::uint32_t> nearest_labels(const GridLevel& level);

}  // namespace pomona
