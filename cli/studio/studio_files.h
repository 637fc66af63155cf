// The files of the studio's page, embedded when the program was built.
#pragma once

#include <span>

#include "generator/base/embedded_file.h"

namespace pomona {

std::span<const EmbeddedFile> studio_files();

}  // namespace pomona
