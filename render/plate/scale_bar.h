// The length and the text of a figure's scale bar.
#pragma once

#include <string>

namespace pomona {

/// A round length: 1, 2 or 5 times a power of ten metres.
struct ScaleLength {
  double metres = 0;
  std::string text;   ///< "2 cm"
  double pixels = 0;  ///< length; 0 without a scale
};

/// The longest bar of at most `max` pixels.
/// \param pixels_per_metre 0 = no scale
ScaleLength scale_length(double max, double pixels_per_metre);

}  // namespace pomona
