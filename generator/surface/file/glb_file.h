// Reads meshes from binary glTF 2.0 (.glb).
#pragma once

#include <string>
#include <string_view>

#include "generator/surface/file/plain_mesh.h"

namespace pomona {

/// Triangles and COLOR_0 of the file's scene, with the transforms of its nodes. Materials, pictures, skins and
/// animations are ignored; nothing outside the file is opened. `object` is the name of a node or of its mesh; empty =
/// all. \throws Error (bad_data) that names the mesh.
PlainMesh parse_glb(std::string_view bytes, const std::string& file, const std::string& object);

}  // namespace pomona
