// What pieces and dishes collide with, in every file.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/piece/solid.h"
#include "render/export/convex_hull.h"

namespace pomona {

/// What the reader of a file can do with a dish, which stands still.
enum class StillShape : std::uint8_t {
  triangles,  ///< its own triangles are what others collide with
  parts,      ///< convex parts alone
};

/// Convex parts of a solid, in its frame; of a dish whose triangles serve none.
/// \param hulls parts of a piece, at most; with 1 the part is its hull. Dishes are divided as far as they need.
std::vector<ConvexHull> collision_parts(const Solid& solid, int hulls, StillShape still);

}  // namespace pomona
