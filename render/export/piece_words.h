// What a file says of a piece in words and numbers: the same in glTF and USD.
#pragma once

#include <string>

#include "generator/piece/solid.h"
#include "render/export/styled_mesh.h"

namespace pomona {

/// The command line that makes this piece's mesh again, coloured and textured as in this file; empty for what is no
/// piece of a known fruit.
std::string command_for(const Solid& solid, const ExportOptions& options, const std::string& ending);

/// Where a piece turns about: its centre of mass, to the precision of vertices. The origin for what was never cut out
/// of a fruit, a dish for one.
glm::vec3 pivot_of(const Solid& solid);

}  // namespace pomona
