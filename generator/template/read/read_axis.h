// Reads the [axis] and the [bend] of a template file.
#pragma once

#include "generator/template/read/read_curve.h"
#include "generator/template/template.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// Reads both into fruit.bend. They must leave room for what is drawn along the axis.
void read_axis_of(const TomlTable& root, CurveReader& curves, Template& fruit);

}  // namespace pomona
