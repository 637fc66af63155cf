// The files render/lettering/*.letters, as they were when the program was built.
#pragma once

#include <span>

#include "generator/base/embedded_file.h"

namespace pomona {

/// The files, in the order of their names.
std::span<const EmbeddedFile> letter_files();

}  // namespace pomona
