// Reduces the number of colours. POV-Ray has textures at vertices, not colours, and copies all textures for each
// instance.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace pomona::pov {

/// A colour, sRGB in steps, and the index of its finish.
using FinishedColor = std::array<int, 4>;

/// For each colour a representative, by median cut [Heckbert 1982]: the middle of the colours in its box. There are at
/// most `max` representatives, but at least one per finish. If there are at most `max` colours, nothing changes.
std::vector<FinishedColor> few_colors(const std::vector<FinishedColor>& colors, std::size_t max);

}  // namespace pomona::pov
