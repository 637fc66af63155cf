// The [variation] and [bend] of a template file.
#pragma once

#include "generator/template/axis_bend.h"
#include "generator/template/read/toml_document.h"
#include "generator/template/variation_sketch.h"

namespace pomona {

VariationSketch read_variation(const TomlTable& table);
AxisBend read_bend(const TomlTable& table);

}  // namespace pomona
