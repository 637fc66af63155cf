// Where the program's own files lie: beside it in a source tree, or installed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pomona {

/// build/pomona lies beside templates/; an installed bin/pomona beside share/pomona/templates. Whether they are there
/// is not looked at.
/// \param kind "templates" or "styles"
std::vector<std::filesystem::path> program_folders(const std::string& kind);

/// Those that are there, and after them a folder of that kind within the current one, and the current one itself.
std::vector<std::filesystem::path> searched_folders(const std::string& kind);

}  // namespace pomona
