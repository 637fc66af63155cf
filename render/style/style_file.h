// From a style's TOML to a Style (docs/reference/style.md), every error with file, line and column.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "render/style/style.h"

namespace pomona {

/// `file` is the name used in messages.
/// \throws Error (bad_data) with all that is wrong, unknown keys included, ordered by position.
Style parse_style(std::string_view toml, const std::string& file);

/// The same from disk. \throws Error (input_missing) if it cannot be read.
Style read_style(const std::filesystem::path& file);

/// True for a .toml file that says `kind = "style"`.
bool is_style_file(const std::filesystem::path& file);

}  // namespace pomona
