// Spots and patches as template files spell them.
#pragma once

#include <vector>

#include "generator/template/spot_sketch.h"
#include "generator/template/surface_sketch.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// [{ place = [0.3, 200], size = "40mm", color = "#..." }, { spacing = "4mm", size = ["1mm", "2mm"], color = ... }].
/// \param faces_air whether the side does: relief is for such sides.
std::vector<SpotSketch> read_spots(const TomlValue& value, SurfaceType type, bool faces_air);

}  // namespace pomona
