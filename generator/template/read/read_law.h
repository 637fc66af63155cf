// Reads the [law.NAME] tables of a template file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/template/law_sketch.h"
#include "generator/template/read/read_curve.h"
#include "generator/template/surface_sketch.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// All laws of [law]; its keys are their names.
std::vector<LawSketch> read_laws(const TomlTable& table, CurveReader& curves);

/// Reads `law = "NAME"` of what needs one.
/// \return its index; nothing after a fault, which is noted
std::optional<int> read_law_name(const TomlValue& value, const std::vector<LawSketch>& laws);

/// The same for grains or spots, which then take no `spacing`, on a surface of this type.
std::optional<int> read_law_name(const TomlTable& table, const std::vector<LawSketch>& laws, SurfaceType type);

}  // namespace pomona
