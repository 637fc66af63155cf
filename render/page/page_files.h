// The files that a page is made of, as they were when the program was built.
#pragma once

#include <span>

#include "generator/base/embedded_file.h"

namespace pomona {

std::span<const EmbeddedFile> page_files();

}  // namespace pomona
