// The files of pages, built into the program.
#pragma once

#include <span>

#include "generator/base/embedded_file.h"

namespace pomona {

std::span<const EmbeddedFile> page_files();

}  // namespace pomona
