// Stippling: tones as dots, which are denser in dark areas.
#pragma once

#include <vector>

#include "render/marks/mark.h"
#include "render/marks/tone_map.h"

namespace pomona {

/// Lengths in pixels.
struct StippleOptions {
  double width = 2;        ///< width of a dot
  double lightest = 0.02;  ///< darkness below which there are no dots
};

/// Dots of nearly one size that keep a distance of 1.48 radii / sqrt(darkness): a dense packing of discs at this
/// distance covers that share of the paper. Dots are thrown one by one [Cook 1986] and kept if there is room, until
/// hardly any finds room.
std::vector<Mark> stippled(const ToneMap& tones, const StippleOptions& options = {});

}  // namespace pomona
