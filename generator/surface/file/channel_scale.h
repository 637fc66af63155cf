// Colours written as floats: up to 1, or, as some scanning programs have it, up to 255.
#pragma once

namespace pomona {

/// What stands for a full channel in a file whose largest channel is this one. Clamped lights go a little beyond 1.
inline double white_of_floats(double largest) { return largest > 2 ? 255 : 1; }

}  // namespace pomona
