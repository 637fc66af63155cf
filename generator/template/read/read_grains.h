// Reads one [[grains]] table of a template file.
#pragma once

#include "generator/template/template.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// `fruit` has its parts and surfaces already. The caller checks the name.
GrainSketch read_grains(const TomlTable& table, const Template& fruit);

}  // namespace pomona
