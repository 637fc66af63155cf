// Solids side by side on the table, at one scale, for a family of variants.
#pragma once

#include <vector>

#include "generator/scene/scene.h"

namespace pomona {

/// The solids in their order along +X on the ground, each in the pose that laid_out() gives it alone. The gaps are a
/// tenth of the largest width. The view is from the front and a little above.
Scene in_a_row(std::vector<Solid> solids);

}  // namespace pomona
