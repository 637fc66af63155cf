// The place of the running program. The Python module has its own program_folders().
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pomona {

/// The running program's file; without /proc (a bare chroot), from the name it was started by.
std::filesystem::path this_program();

/// build/pomona lies beside templates/; an installed bin/pomona beside share/pomona/templates. The folders may not
/// exist.
/// \param kind "templates", "scenes" or "styles"
std::vector<std::filesystem::path> program_folders(const std::string& kind);

}  // namespace pomona
