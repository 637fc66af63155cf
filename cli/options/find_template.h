// Where templates are looked for.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/options/program_folders.h"

namespace pomona {

/// The file behind a name from `pomona list`, or behind a path. \throws Error (input_missing) with the nearest
/// known name.
std::filesystem::path find_template(const std::string& name_or_path);

/// All template files of the program that names stand for, sorted by name. \throws Error (input_missing), with where
/// was looked, if there are none.
std::vector<std::filesystem::path> all_templates();

/// One's own in ./templates and the current folder, which answer to their names, too, unless one of the program's hides
/// them. Sorted by name.
std::vector<std::filesystem::path> own_templates();

}  // namespace pomona
