// Reads meshes from binary glTF 2.0 (.glb).
#pragma once

#include <string>
#include <string_view>

#include "generator/surface/file/plain_mesh.h"

namespace pomona {

/// Triangles and COLOR_0 of the file's scene, placed by nodes, instances, skins and morph targets. Materials, pictures
/// and animations are ignored, and nothing outside the file is opened. A required extension that is not supported is
/// refused by name. `object` is the name of a node, or of mesh data if no node has that name; empty = all.
/// \throws Error (bad_data) that names the mesh.
PlainMesh parse_glb(std::string_view bytes, const std::string& file, const std::string& object);

}  // namespace pomona
