// Where styles are looked for.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "render/style/style.h"

namespace pomona {

/// The style behind a name (the program's tree first, then the current folder, then what was built into the program)
/// or behind a path.
/// \throws Error (usage) with the nearest known name, (input_missing) for a path that leads nowhere, (bad_data) for a
/// file that is no style.
Style find_style(const std::string& name_or_path);

/// All that names stand for, sorted by name.
std::vector<Style> all_known_styles();

}  // namespace pomona
