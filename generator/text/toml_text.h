// The text of a TOML file, as far as one may be long, and what kind of file it is.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

namespace pomona {

/// At most one byte more than TomlLimits allow: enough to know that the file goes beyond them.
/// \throws Error (input_missing) if it cannot be read.
std::string read_toml_text(const std::filesystem::path& file);

/// True for a .toml file with a line that begins, after blanks, with one of these headings: "[bowl]". Nothing else is
/// looked at, so that a file full of mistakes is still known for what it is meant to be.
bool has_toml_heading(const std::filesystem::path& file, std::initializer_list<std::string_view> headings);

}  // namespace pomona
