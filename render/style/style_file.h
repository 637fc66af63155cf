// Reads a Style from TOML, on disk or built into the program (docs/reference/style.md); every error has file, line and
// column.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "render/style/style.h"

namespace pomona {

/// `file` is the name used in messages.
/// \throws Error (bad_data) with all errors, also unknown keys, ordered by position.
Style parse_style(std::string_view toml, const std::string& file);

/// The same from disk.
/// \throws Error (input_missing) if it cannot be read.
Style read_style(const std::filesystem::path& file);

/// The styles that are built into the program, in the order of their names.
std::vector<Style> all_styles();

/// One of all_styles().
/// \throws Error (usage) with the nearest name.
Style style_named(std::string_view name);

/// True for a .toml file that says `kind = "style"`.
bool is_style_file(const std::filesystem::path& file);

}  // namespace pomona
