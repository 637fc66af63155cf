// The manual page, pomona(1).
#pragma once

#include <span>
#include <string>

#include "cli/pages/command_line.h"

namespace pomona {

/// A page in groff's man macros.
std::string manual_page(std::span<const TypedCommand> commands, const std::string& version);

}  // namespace pomona
