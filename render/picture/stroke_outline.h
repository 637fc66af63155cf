// A stroke's outline as a path, for drawing programs.
#pragma once

#include <string>
#include <vector>

#include "render/picture/stroke.h"

namespace pomona {

/// SVG path data, closed, to be filled by the nonzero rule: along one side of the stroke and back along the other in
/// cubic curves with as few nodes as stay within a fifth of a pixel, with round ends. Hundredths of a pixel. Empty for
/// a stroke of less than two points.
std::string stroke_outline(const std::vector<StrokePoint>& stroke);

/// A number with up to two decimals: "12", "0.5", "-3.25".
std::string hundredths(double number);

}  // namespace pomona
