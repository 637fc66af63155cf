// The pictures of the error atlas: one section coloured in several ways, side by side, and its differences.
#pragma once

#include <span>
#include <vector>

#include "generator/cut/section/cross_section.h"
#include "render/image/image.h"

namespace pomona::bench {

/// The section with these colours at its interior vertices, in their order.
CrossSection with_colors(CrossSection section, std::span<const Color> interior);

/// The section in the colours of difference: white for none, through yellow and red to black for `full_scale` parts
/// of 255 in the worst channel.
CrossSection with_differences(CrossSection section, std::span<const Color> interior, std::span<const Color> truth,
                              double full_scale);

/// All sections at one size in a row, drawn plainly.
Image side_by_side(std::span<const CrossSection> sections, int panel_width, int panel_height);

}  // namespace pomona::bench
