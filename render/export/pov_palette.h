// Few colours for many: POV-Ray has no colours at vertices but textures, and copies all of them with each instance.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace pomona::pov {

/// A colour, sRGB in steps, and the number of the finish that it is seen with.
using FinishedColor = std::array<int, 4>;

/// For each of `colors` one of at most `most`, or as many as there are finishes: the middle of those that were put
/// into one box with it [Heckbert 1982]. Finishes stay apart. Where there are no more than `most`, nothing changes.
std::vector<FinishedColor> few_colors(const std::vector<FinishedColor>& colors, std::size_t most);

}  // namespace pomona::pov
