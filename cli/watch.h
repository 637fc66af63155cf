// --watch: a command's outputs are made anew when a file that it read changes.
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "cli/shared_options.h"
#include "generator/base/error.h"

namespace pomona {

/// The files behind the words of a command line: templates, scenes and styles by name or path, files that knives name
/// (mesh:blade.ply), and all that those which are TOML name in turn: sketches, meshes, other templates.
std::set<std::filesystem::path> files_behind(const std::vector<std::string>& words);

/// \throws Error (usage) if a file that is to be written is one of those behind `words`: it would be lost.
void check_not_read(const std::vector<std::string>& written, const std::vector<std::string>& words);

/// Makes, and with --watch makes again whenever one of the files behind `words` has changed and has come to rest, until
/// a signal ends the program. What goes wrong is printed then, and watching goes on. \param written names of files that
/// are written, the statistics aside. \throws Error (usage) as check_not_read(), and with --watch if one of the files
/// is standard output, which cannot be made anew; without it what `make` throws.
ExitStatus made_or_watched(const SharedOptions& options, std::vector<std::string> written,
                           const std::vector<std::string>& words, const std::function<ExitStatus()>& make);

}  // namespace pomona
