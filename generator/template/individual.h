// The colours of one individual.
#pragma once

#include <cstdint>
#include <vector>

namespace pomona {

/// A change of colour in OKLab: lightness is added, chroma multiplied, hue turned by radians.
struct ColorShift {
  double lightness = 0;
  double chroma = 1;
  double hue = 0;
};

/// The colours of an individual; by default those of the drawing.
struct Individual {
  double ripeness = 1;             ///< 0..2, see RipenessSketch
  double browning = 0;             ///< 0..1, see BrowningSketch
  std::uint32_t patches = 0;       ///< seed of the patches of ripeness and browning
  std::vector<ColorShift> shifts;  ///< one per part; empty = none
};

}  // namespace pomona
