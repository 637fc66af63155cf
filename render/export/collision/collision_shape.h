// What pieces and dishes collide with, in every file.
#pragma once

#include <vector>

#include "generator/piece/solid.h"
#include "render/export/convex_hull.h"

namespace pomona {

/// Convex parts of a solid, in its frame.
/// \param hulls parts of a piece, at most; with 1 the part is its hull. Dishes are divided as far as they need.
std::vector<ConvexHull> collision_parts(const Solid& solid, int hulls);

}  // namespace pomona
