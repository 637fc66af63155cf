// What the shells complete after "pomona": commands, options and their values.
#pragma once

#include <span>
#include <string>

#include "cli/pages/command_line.h"

namespace pomona {

/// A script each. Names of templates, scenes and styles are asked of the program when they are wanted.
std::string bash_completion(std::span<const TypedCommand> commands);
std::string zsh_completion(std::span<const TypedCommand> commands);
std::string fish_completion(std::span<const TypedCommand> commands);

}  // namespace pomona
