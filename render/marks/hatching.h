// Hatching: tones as lines that follow the shapes, thicker in dark areas, crossed in the darkest ones.
#pragma once

#include <vector>

#include "render/marks/flow_field.h"
#include "render/marks/mark.h"
#include "render/marks/tone_map.h"

namespace pomona {

/// Lengths in pixels.
struct HatchOptions {
  double spacing = 6;      ///< distance between lines
  double width = 4;        ///< width of lines in full ink
  double lightest = 0.06;  ///< darkness below which there is no line
  double crossing = 0.6;   ///< darkness above which a second set of lines crosses the first
};

/// Evenly spaced lines along the flow [Jobard and Lefer 1997]. Their width follows from the tone; they end in light
/// areas. Two lines of a set are never nearer than half the spacing, except where one ends.
std::vector<Mark> hatched(const ToneMap& tones, const FlowField& flow, const HatchOptions& options = {});

}  // namespace pomona
