// Blurring of fields of numbers.
#pragma once

#include <vector>

namespace pomona {

/// The field blurred by about a Gaussian of this deviation, in pixels, as three box filters [Wells 1986]; values of the
/// border continue outside. Sums have one order, so the bits are the same everywhere.
/// \param field `width` times `height` numbers by rows.
std::vector<float> blurred(std::vector<float> field, int width, int height, double deviation);

}  // namespace pomona
