// Colours written as floats: up to 1, or, as some scanning programs have it, up to 255.
#pragma once

namespace pomona {

/// The value of a full channel in a file with this largest channel. Clamped lights may slightly exceed 1.
inline double white_of_floats(double largest) { return largest > 2 ? 255 : 1; }

}  // namespace pomona
