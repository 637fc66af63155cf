// Solids side by side on the table, at one scale: a family of variants.
#pragma once

#include <vector>

#include "generator/scene/scene.h"

namespace pomona {

/// The solids in their order along +X on the ground, each posed as laid_out() poses it by itself, with a tenth of the
/// largest one's width between them; seen from the front and a little above.
Scene in_a_row(std::vector<Solid> solids);

}  // namespace pomona
