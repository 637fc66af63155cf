// Quadric decimation of a solid's mesh [Garland & Heckbert 1997], by OpenMesh.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "generator/piece/lod/collapse_rules.h"

namespace pomona {

/// The target of a level.
struct LevelTarget {
  std::size_t faces = 0;  ///< largest number of faces; more remain if the bounds require it
  CollapseBounds bounds;
};

/// The faces of each level. Each level continues from the one before: face numbers decrease, bounds increase.
std::vector<std::vector<CollapseRules::Face>> decimated(const VertexFans& fans, const Solid& solid,
                                                        std::span<const LevelTarget> levels);

}  // namespace pomona
