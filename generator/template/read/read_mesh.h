// Reads one [[mesh]] table of a template file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "generator/template/mesh_sketch.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// Reads the table and the bytes of its file, which lies in `folder` (the template's) or below. It shares the bytes of
/// a file that `known` meshes have read.
MeshSketch read_mesh(const TomlTable& table, const std::vector<std::string>& parts, const std::filesystem::path& folder,
                     const std::vector<MeshSketch>& known);

}  // namespace pomona
