// Species draw by themselves.
#pragma once

#include <string_view>

#include "generator/base/random.h"

namespace pomona {

/// The key under which a species draws everything: that of the user, mixed with the template's name, not with its path
/// or contents. Two species share nothing at equal seeds, and a template that is edited keeps its variants. Seed 0 with
/// index 0, the fruit as drawn, stays what it is.
VariantKey species_key(VariantKey key, std::string_view species);

}  // namespace pomona
