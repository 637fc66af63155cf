// Where what is running lies. The Python module has the second of these functions of its own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pomona {

/// The running program's file; where /proc is not mounted (a bare chroot), by what it was started as.
std::filesystem::path this_program();

/// build/pomona lies beside templates/; an installed bin/pomona beside share/pomona/templates. Whether they are there
/// is not looked at.
/// \param kind "templates", "scenes" or "styles"
std::vector<std::filesystem::path> program_folders(const std::string& kind);

}  // namespace pomona
