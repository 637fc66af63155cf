// Which collapses are allowed: limits for surface, borders and colours, and forbidden changes.
#pragma once

#include <cstdint>

#include "generator/piece/lod/collapse.h"
#include "generator/piece/lod/level_mesh.h"
#include "generator/piece/lod/patch_cover.h"

namespace pomona {

/// Whether no triangle would turn over or become a needle. This does not depend on bounds. The ring begins with the
/// neighbour that the vertex moves to.
bool keeps_sides(const LevelSource& source, const LevelMesh& level, const Ring& ring);

/// Whether a collapse keeps to the bounds. If so, its chains have been merged and its targets know the vertices that
/// they hold; else nothing has changed.
bool allows(const LevelSource& source, LevelMesh& level, const LevelBounds& bounds, PatchCover& cover,
            Collapse& collapse);

}  // namespace pomona
