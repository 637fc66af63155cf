// Prepares runs for the pen: overlapping runs are drawn once, and runs that continue each other become one line
// [Northrup & Markosian 2000, section 3.2].
#pragma once

#include <span>
#include <vector>

#include "render/strokes/hidden_lines.h"

namespace pomona {

/// The smallest distance of two lines, by instance; it follows from the width of the pen.
struct PenWidths {
  double outline = 0, inner = 0;  ///< pixels
};

/// Where two runs are parallel and nearer to each other than the pen is wide, only one is kept: rims before contours
/// before ridges before finer lines; among equal ones, the nearer to the eye. A run that is shortened still overlaps
/// the other a little.
std::vector<VisibleRun> without_overlaps(std::vector<VisibleRun> runs, std::span<const PenWidths> pens, int width,
                                         int height);

/// Ends of one instance's runs that lie within `reach` pixels and turn by at most 60 degrees become joints, the
/// straightest and nearest first.
std::vector<VisibleRun> joined_runs(std::vector<VisibleRun> runs, double reach);

}  // namespace pomona
