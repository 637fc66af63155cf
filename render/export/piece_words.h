// Texts and numbers about a piece, for glTF and USD files.
#pragma once

#include <string>

#include "generator/piece/solid.h"
#include "render/export/styled_mesh.h"

namespace pomona {

/// The command that makes this piece's mesh again, with the colours and textures of this file; empty if it is not a
/// piece of a known fruit.
std::string command_for(const Solid& solid, const ExportOptions& options, const std::string& ending);

/// Whether a solid is a piece of fruit, or a whole one, and no dish. Pieces move in simulations, dishes stand still.
bool is_fruit(const Solid& solid);

/// The pivot of a piece: its centre of mass, with the precision of vertices. For solids that are not cut from a fruit,
/// such as dishes, it is the origin.
glm::vec3 pivot_of(const Solid& solid);

}  // namespace pomona
