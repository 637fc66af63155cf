// One solid as POV-Ray's mesh2.
#pragma once

#include <string>

#include "render/export/pov_finish.h"
#include "render/export/styled_mesh.h"

namespace pomona::pov {

/// "#declare Mesh_<index> = mesh2 { ... }" in units of 10^unit_exponent metres, with the scene's finishes. Whole
/// numbers parse fastest and are shortest: positions are multiples of a millionth of the mesh's size or less, normals
/// thousandths. Equal positions stay equal, so the mesh stays closed. \param max_textures of which each takes about
/// 1 KB of POV-Ray's memory, and as much again for every instance.
std::string mesh_text(const StyledMesh& mesh, const Solid& solid, const Finishes& finishes, std::size_t index,
                      int unit_exponent, std::size_t max_textures);

}  // namespace pomona::pov
