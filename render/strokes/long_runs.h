// Runs made fit for a pen: what overlaps is drawn once, and what continues each other is one line
// [Northrup & Markosian 2000, section 3.2].
#pragma once

#include <span>
#include <vector>

#include "render/strokes/hidden_lines.h"

namespace pomona {

/// How near two lines may come: a share of the width of the pen that draws them, by instance.
struct PenWidths {
  double outline = 0, inner = 0;  ///< pixels
};

/// Where two runs go the same way closer to each other than the pen is wide, only one is kept: rims before contours
/// before ridges before finer lines, then what is nearer to the eye. A run that is cut short reaches a little under the
/// one that stays.
std::vector<VisibleRun> without_overlaps(std::vector<VisibleRun> runs, std::span<const PenWidths> pens, int width,
                                         int height);

/// Ends of one instance's runs that lie within `reach` pixels and turn by at most 60 degrees become joints, the
/// straightest and nearest first.
std::vector<VisibleRun> joined_runs(std::vector<VisibleRun> runs, double reach);

}  // namespace pomona
