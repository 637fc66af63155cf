// Each species has random numbers of its own.
#pragma once

#include <string_view>

#include "generator/base/random.h"

namespace pomona {

/// True for the key of the fruit as drawn: seed 0 with index 0.
bool is_drawn(VariantKey key);

/// The key of all random numbers of a species: the user's key, mixed with the template's name, but not with its path or
/// contents. So two species have nothing in common at equal seeds, and an edited template keeps its variants. The
/// key of the fruit as drawn is not changed.
VariantKey species_key(VariantKey key, std::string_view species);

}  // namespace pomona
