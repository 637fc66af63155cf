// Hatching: tones as lines that follow the forms, broader in the dark, crossed where it is darkest.
#pragma once

#include <vector>

#include "render/marks/flow_field.h"
#include "render/marks/mark.h"
#include "render/marks/tone_map.h"

namespace pomona {

/// Lengths in pixels.
struct HatchOptions {
  double spacing = 6;      ///< from line to line
  double width = 4;        ///< of lines in full ink
  double lightest = 0.06;  ///< darkness below which there is no line
  double crossing = 0.6;   ///< darkness above which a second set of lines crosses the first
};

/// Evenly spaced lines along the flow [Jobard and Lefer 1997], as broad as the tone asks for; they end where it gets
/// light. No two lines of a set come nearer than half their spacing, but where one ends.
std::vector<Mark> hatched(const ToneMap& tones, const FlowField& flow, const HatchOptions& options = {});

}  // namespace pomona
