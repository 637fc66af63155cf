// The files that a command reads, as far as the words of its line tell.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace pomona {

/// The files behind the words of a command line: templates, scenes and styles by name or path, files that knives name
/// (mesh:blade.ply), and all that those which are TOML name in turn: sketches, meshes, other templates.
std::set<std::filesystem::path> files_behind(const std::vector<std::string>& words);

/// \throws Error (usage) if a file that is to be written is one of those behind `words`: it would be lost.
void check_not_read(const std::vector<std::string>& written, const std::vector<std::string>& words);

}  // namespace pomona
