// FLIP's map as a picture.
#pragma once

#include "render/compare/flip.h"

namespace pomona {

/// Black where nothing differs, over purple and orange to pale yellow: the colours of the paper ("magma", Smith and
/// van der Walt).
Image heat_map(const FlipMap& map);

}  // namespace pomona
