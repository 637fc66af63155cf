// The files that the studio's page is made of, as they were when the program was built.
#pragma once

#include <span>

#include "generator/base/embedded_file.h"

namespace pomona {

std::span<const EmbeddedFile> studio_files();

}  // namespace pomona
