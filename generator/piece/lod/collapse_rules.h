// Which collapses are allowed: limits for surface, borders and colours, and what is forbidden.
#pragma once

#include <cstdint>

#include "generator/piece/lod/collapse.h"
#include "generator/piece/lod/level_mesh.h"
#include "generator/piece/lod/patch_cover.h"

namespace pomona {

/// Whether a collapse keeps to the bounds. If so, it has merged its chains, and knows what its targets hold; else all
/// is as it was.
bool allows(const LevelSource& source, LevelMesh& level, const LevelBounds& bounds, PatchCover& cover,
            Collapse& collapse);

}  // namespace pomona
