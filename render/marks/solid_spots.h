// Solid spots: small things that are much darker than what is around them, such as seeds, in full ink.
#pragma once

#include <vector>

#include "render/marks/mark.h"
#include "render/marks/tone_map.h"

namespace pomona {

struct SpotOptions {
  double around = 24;     ///< pixels: the deviation of the blur that gives the mean of what is around
  double longest = 50;    ///< pixels: spots, or rows of spots that touch, are at most so wide and so high
  double dark = 0.66;     ///< least darkness of a spot: nearly black
  double contrast = 0.2;  ///< by so much it is darker than what is around
};

/// Lines that fill each spot, one for each row of pixels. Tones should hardly be blurred, and
/// not be stretched.
std::vector<Mark> solid_spots(const ToneMap& tones, const SpotOptions& options = {});

}  // namespace pomona
