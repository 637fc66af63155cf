// Finds styles.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "render/style/style.h"

namespace pomona {

/// The style of a name (in the program's tree, then in the current folder, then built into the program) or of a path.
/// \throws Error (usage) with the nearest known name, (input_missing) for a path without a file, (bad_data) for a file
/// that is no style.
Style find_style(const std::string& name_or_path);

/// All styles with a name, sorted.
std::vector<Style> all_known_styles();

}  // namespace pomona
