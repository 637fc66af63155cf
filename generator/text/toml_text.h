// Reads the text of a TOML file up to a limit, and tells its kind.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

namespace pomona {

/// Reads at most one byte more than TomlLimits allow, enough to know that the file exceeds them.
/// \throws Error (input_missing) if it cannot be read.
std::string read_toml_text(const std::filesystem::path& file);

/// True for a .toml file with a line that begins, after blanks, with one of these headings: "[bowl]", and none that
/// begins with one of `without`. It checks nothing else, so that a file full of mistakes is still recognised.
bool has_toml_heading(const std::filesystem::path& file, std::initializer_list<std::string_view> headings,
                      std::initializer_list<std::string_view> without = {});

}  // namespace pomona
