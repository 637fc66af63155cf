// Which collapses are allowed: limits for surface, borders and colours, and forbidden changes.
#pragma once

#include <cstdint>

#include "generator/piece/lod/collapse.h"
#include "generator/piece/lod/level_mesh.h"
#include "generator/piece/lod/patch_cover.h"

namespace pomona {

/// Whether a collapse keeps to the bounds. If so, its chains have been merged and its targets know the vertices that
/// they hold; else nothing has changed.
bool allows(const LevelSource& source, LevelMesh& level, const LevelBounds& bounds, PatchCover& cover,
            Collapse& collapse);

}  // namespace pomona
