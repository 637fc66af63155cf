// The lattices of a scene's guides as texels of a buffer.
#pragma once

#include <vector>

#include <glm/vec4.hpp>

#include "generator/scene/scene.h"

namespace pomona {

/// For each solid: the spacing in metres and the row of 64 texels where the table of its lattice's blocks begins, -1
/// without a lattice; its lowest node; its number of nodes. Then the lattices, once each, however many pieces share
/// one: for each block its row, -1 if it has none; and the blocks' nodes (shaders/guide_lattice.glsl).
std::vector<glm::vec4> lattice_texels(const std::vector<Solid>& solids);

}  // namespace pomona
