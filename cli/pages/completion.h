// Completions of shells after "pomona": commands, options and their values.
#pragma once

#include <span>
#include <string>

#include "cli/pages/command_line.h"

namespace pomona {

/// A script for each shell. It asks the program for names of templates, scenes and styles.
std::string bash_completion(std::span<const TypedCommand> commands);
std::string zsh_completion(std::span<const TypedCommand> commands);
std::string fish_completion(std::span<const TypedCommand> commands);

}  // namespace pomona
