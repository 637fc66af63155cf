// Reads what [[grains]] with `inside` say of the volume that they fill.
#pragma once

#include "generator/template/template.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// Reads `inside`, `sizes`, `proportions` and the rest of these keys into the grain's surface, volume and form.
void read_grain_volume(const TomlTable& table, const Template& fruit, GrainSketch& grain);

}  // namespace pomona
