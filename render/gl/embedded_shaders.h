// The files of shaders/, built into the program.
#pragma once

#include <span>

#include "generator/base/embedded_file.h"

namespace pomona {

/// All of them, in the order of their names.
std::span<const EmbeddedFile> embedded_shaders();

}  // namespace pomona
