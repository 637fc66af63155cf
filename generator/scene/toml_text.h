// The text of a TOML file, as far as one may be long.
#pragma once

#include <filesystem>
#include <string>

namespace pomona {

/// At most one byte more than TomlLimits allow: enough to know that the file goes beyond them.
/// \throws Error (input_missing) if it cannot be read.
std::string read_toml_text(const std::filesystem::path& file);

}  // namespace pomona
