// A variant's numbers before anything rounds them.
#pragma once

#include <vector>

#include "generator/template/template.h"

namespace pomona {

/// Curves, angles of folds, bend, proportions, sizes of grains, reference radii and shifts of colour, in the order of
/// the template's fields; after each list how many it has. Lengths in metres, angles in radians.
std::vector<double> variant_numbers(const Template& variant);

}  // namespace pomona
