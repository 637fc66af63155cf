// Reads the [[sheets]] tables of a template file.
#pragma once

#include <vector>

#include "generator/template/read/read_curve.h"
#include "generator/template/template.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// All of [[sheets]]; the fruit has its parts and surfaces, from whose names those of the sheets differ.
std::vector<SheetSketch> read_sheets(const TomlTable& root, CurveReader& curves, const Template& fruit);

}  // namespace pomona
