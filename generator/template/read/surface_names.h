// The names of drawn surfaces, for keys that name one.
#pragma once

#include <string>
#include <vector>

#include "generator/template/template.h"

namespace pomona {

/// In the order of the template's surfaces.
std::vector<std::string> surface_names(const Template& fruit);

}  // namespace pomona
