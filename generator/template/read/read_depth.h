// Values that change with the depth below the skin, as templates write them.
#pragma once

#include "generator/template/ramp.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// A number, or stops [["0mm", number], ["8mm", number], ...] by the depth below the skin, metres.
Ramp<double> read_depth_ramp(const TomlValue& value, double fallback, Within within);

}  // namespace pomona
