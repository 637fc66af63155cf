// One [[mesh]] of a template file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "generator/template/mesh_sketch.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// Reads the table, and the bytes of the file it names, which lies in `folder` (the template's) or below. A file that
/// `known` meshes have read already is shared with them.
MeshSketch read_mesh(const TomlTable& table, const std::vector<std::string>& parts, const std::filesystem::path& folder,
                     const std::vector<MeshSketch>& known);

}  // namespace pomona
