// Lines on cut faces where the colour jumps from one side to the other.
#pragma once

namespace pomona {

/// How opaque a line between two colours should be, from their distance in OKLab: those that one hardly tells
/// apart get none.
double line_opacity(double oklab_distance);

}  // namespace pomona
