// Reads meshes from binary glTF 2.0 (.glb).
#pragma once

#include <string>
#include <string_view>

#include "generator/surface/file/plain_mesh.h"

namespace pomona {

/// Triangles and COLOR_0 of the file's scene, where its nodes, their instances, skins and morph targets put them;
/// materials, pictures and animations are left alone, and nothing outside the file is opened. An extension that the
/// file requires and that is not read is refused by name. `object` is the name of a node, or of mesh data where no node
/// has that name; empty = all.
/// \throws Error (bad_data) that names the mesh.
PlainMesh parse_glb(std::string_view bytes, const std::string& file, const std::string& object);

}  // namespace pomona
