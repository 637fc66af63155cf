// Reads the [variation] of a template file.
#pragma once

#include "generator/template/axis_bend.h"
#include "generator/template/template.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// Reads all but colours, which come last (read_ripeness.h). `fruit` has its symmetry and surfaces already.
VariationSketch read_variation(const TomlTable& table, const Template& fruit);

}  // namespace pomona
