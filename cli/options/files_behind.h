// The files that a command reads, by the words of its line.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace pomona {

/// The files behind the words of a command line: templates, scenes and styles by name or path, files that knives name
/// (mesh:blade.ply), and all files that TOML files among them name: sketches, meshes, other templates.
std::set<std::filesystem::path> files_behind(const std::vector<std::string>& words);

/// \throws Error (usage) if an output is one of the files behind `words`, which would be lost.
void check_not_read(const std::vector<std::string>& written, const std::vector<std::string>& words);

}  // namespace pomona
