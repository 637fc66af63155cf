// Quadric decimation of a solid's mesh [Garland & Heckbert 1997], by OpenMesh.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "generator/piece/lod/collapse_rules.h"

namespace pomona {

/// A level to come.
struct LevelTarget {
  std::size_t faces = 0;  ///< no more than these, if the bounds let it
  CollapseBounds bounds;
};

/// The faces that are left at each of the levels, which grow from one another: targets descend, bounds ascend.
std::vector<std::vector<CollapseRules::Face>> decimated(const VertexFans& fans, const Solid& solid,
                                                        std::span<const LevelTarget> levels);

}  // namespace pomona
