// Directions for draft and final, as far apart from each other as possible.
#pragma once

#include <vector>

#include "generator/diffusion/pmvc/line_directions.h"

namespace pomona {

/// Lines that were moved from line_directions() down the gradient of the sum of 1 / |a - b|^2 over the ends of all
/// lines until they rested: the error of positive mean values is about a tenth smaller. Neighbours come in pairs (2 i,
/// 2 i + 1), so that the difference within a pair tells how much the colours scatter there.
std::vector<Line> relaxed_draft_lines();  ///< 60
std::vector<Line> relaxed_final_lines();  ///< 192

}  // namespace pomona
