// From the solid to a level: whether every point of the solid lies near the level, which is proved, not sampled.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/piece/lod/level_mesh.h"

namespace pomona {

/// The faces of the solid of which some point may be further from its patch of the level than the bound, in metres.
///
/// Distance to a triangle is convex: what has its corners near one triangle is near that triangle. So each face is
/// tried with the triangles that hold its corners, then in quarters and quarters of quarters. `near` gives and takes,
/// per face of the solid, a triangle of the level that all of it is near; none where there is none. At first each is
/// near itself. Triangles in `changed` are those that are not as they were when `near` was filled.
std::vector<std::uint32_t> uncovered_faces(const LevelSource& source, const LevelMesh& level, double bound,
                                           const std::vector<std::uint8_t>& changed, std::vector<std::uint32_t>& near);

}  // namespace pomona
