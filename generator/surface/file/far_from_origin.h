// Shapes too far from the origin for floats, in which surfaces are stored.
#pragma once

#include <string>

#include "generator/mesh/box.h"

namespace pomona {

/// The largest coordinate in the box.
double distance_of(const Box<double>& box);

/// True if rounding to floats would change the shape in this box by more than a five thousandth of its size, that is,
/// at some 1700 times its size from the origin.
bool is_too_far(const Box<double>& box);

/// "it lies 448 km from the origin: numbers there have steps of 31 mm".
std::string why_too_far(const Box<double>& box);

/// "at = ["-448262.25m", "0m", "12m"]": the key that moves the box's middle to the origin.
std::string at_key(const Box<double>& box);

}  // namespace pomona
