// Walls in the plane that halves a fruit as drawn.
#pragma once

#include <string>
#include <vector>

#include "generator/template/template.h"

namespace pomona {

/// A warning for each fold line with chambers on both sides that lies in the plane z = 0, along which `half` cuts, or
/// within two degrees of it. A half would show the wall between the chambers and neither of them.
std::vector<std::string> half_wall_warnings(const Template& fruit);

}  // namespace pomona
