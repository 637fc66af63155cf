// Where templates are looked for.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/program_folders.h"

namespace pomona {

/// The file behind a name from `pomona list`, or behind a path. \throws Error (input_missing) with the nearest
/// known name.
std::filesystem::path find_template(const std::string& name_or_path);

/// All template files that names stand for, sorted by name. \throws Error (input_missing), with where was looked, if
/// there are none.
std::vector<std::filesystem::path> all_templates();

}  // namespace pomona
