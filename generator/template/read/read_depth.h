// Reads values that change with the depth below the skin.
#pragma once

#include "generator/template/ramp.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// Reads a number, or stops [["0mm", number], ["8mm", number], ...] by the depth below the skin; depths become metres.
Ramp<double> read_depth_ramp(const TomlValue& value, double fallback, Within within);

}  // namespace pomona
