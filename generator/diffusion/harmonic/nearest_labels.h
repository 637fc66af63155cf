// Which side of which surface a node is nearest to, as links go.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/diffusion/harmonic/grid_level.h"

namespace pomona {

/// Per stored node of a level: 2 * triangle, + 1 for its back, of the surface that is reached first over open links;
/// no_side where none is.
constexpr std::uint32_t no_side = 0xffffffffu;
std::vector<std::uint32_t> nearest_labels(const GridLevel& level);

}  // namespace pomona
