// The files under styles/, as they were when the program was built.
#pragma once

#include <span>

#include "generator/base/embedded_file.h"

namespace pomona {

/// In the order of their names.
std::span<const EmbeddedFile> shipped_styles();

}  // namespace pomona
