// Reads the [material.PART] tables of a template file.
#pragma once

#include <string>
#include <vector>

#include "generator/template/material_sketch.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// Returns one material per part, in their order.
std::vector<MaterialSketch> read_materials(const TomlTable& table, const std::vector<std::string>& parts);

}  // namespace pomona
