// The [symmetry] of a template file.
#pragma once

#include "generator/template/read/sketch.h"
#include "generator/template/template.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// Where neither the file nor the sketch (may be null) says where folds begin, they are even.
Symmetry read_symmetry(const TomlTable& table, const Sketch* sketch);

}  // namespace pomona
