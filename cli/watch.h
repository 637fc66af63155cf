// --watch: a command's outputs are made anew when a file that it read changes.
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "generator/base/error.h"

namespace pomona {

/// The files behind the words of a command line: templates, scenes and styles by name or path, files that knives name
/// (mesh:blade.ply), and all that those which are TOML name in turn: sketches, meshes, other templates.
std::set<std::filesystem::path> files_behind(const std::vector<std::string>& words);

/// \throws Error (usage) if one of the outputs is standard output, which cannot be made anew.
void check_watch(const std::vector<std::string>& outputs);

/// Makes, and makes again whenever one of these files has changed and has come to rest, until a signal ends the
/// program. What goes wrong is printed, and watching goes on.
ExitStatus watched(const std::vector<std::string>& words, const std::function<ExitStatus()>& make);

}  // namespace pomona
