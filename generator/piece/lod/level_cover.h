// From the solid to a level: proves, without sampling, that every point of the solid lies near the level.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/piece/lod/level_mesh.h"

namespace pomona {

/// The faces of the solid of which some point may be further from its patch of the level than the bound, in metres.
/// Distance to a triangle is convex, so a face with all corners near one triangle is near that triangle. Each face is
/// tried with the triangles that hold its corners, then in quarters and quarters of quarters. `near` is input and
/// output: for each face of the solid, a triangle of the level that all of the face is near, or none. At first each
/// face is near itself. `changed` marks triangles that have changed since `near` was filled.
std::vector<std::uint32_t> uncovered_faces(const LevelSource& source, const LevelMesh& level, double bound,
                                           const std::vector<std::uint8_t>& changed, std::vector<std::uint32_t>& near);

}  // namespace pomona
