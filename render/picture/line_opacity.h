// Lines on cut faces where the colour jumps from one side to the other.
#pragma once

namespace pomona {

/// The opacity of a line between two colours, from their distance in OKLab. There is no line between colours that can
/// hardly be distinguished.
double line_opacity(double oklab_distance);

}  // namespace pomona
