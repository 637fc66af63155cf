// Levels of a solid's mesh, by edge collapses, the cheapest first.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "generator/piece/lod/level_mesh.h"

namespace pomona {

/// The target of a level.
struct LevelTarget {
  std::size_t faces = 0;  ///< largest number of faces; more remain if the bounds require it
  LevelBounds bounds;
};

/// The faces of each level. Each level continues from the one before: face numbers decrease, bounds increase.
std::vector<std::vector<LevelFace>> decimated(const VertexFans& fans, const SolidMesh& solid,
                                              std::span<const LevelTarget> levels);

}  // namespace pomona
