// One [[grains]] of a template file.
#pragma once

#include "generator/template/template.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// `fruit` has its parts and surfaces already; the name is the caller's to check.
GrainSketch read_grains(const TomlTable& table, const Template& fruit);

}  // namespace pomona
