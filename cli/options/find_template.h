// Finds templates.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/options/program_folders.h"

namespace pomona {

/// The file of a name from `pomona list`, or of a path.
/// \throws Error (input_missing) with the nearest known name.
std::filesystem::path find_template(const std::string& name_or_path);

/// All template files of the program that names stand for, sorted by name.
/// \throws Error (input_missing), with the searched folders, if there are none.
std::vector<std::filesystem::path> all_templates();

/// The user's templates in ./templates and the current folder, sorted by name; a template of the program hides one of
/// the same name.
std::vector<std::filesystem::path> own_templates();

}  // namespace pomona
