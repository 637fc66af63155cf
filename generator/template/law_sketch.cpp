#include "generator/template/law_sketch.h"

#include <cmath>

#include "generator/base/units.h"

namespace pomona {

double beside_whole_turns(double angle) { return angle - 2 * pi * std::round(angle / (2 * pi)); }

}  // namespace pomona
