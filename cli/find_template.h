// Where templates are looked for.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pomona {

/// The folders that hold templates by name: the program's tree first, then the current folder.
std::vector<std::filesystem::path> template_folders();

/// The file behind a name from `pomona list`, or behind a path. \throws Error (input_missing) with the nearest
/// known name.
std::filesystem::path find_template(const std::string& name_or_path);

/// The path itself. \throws Error (input_missing) if there is no such file.
std::filesystem::path existing_file(const std::string& path);

/// All template files that names stand for, sorted by name; those of an earlier folder hide later ones.
std::vector<std::filesystem::path> all_templates();

}  // namespace pomona
