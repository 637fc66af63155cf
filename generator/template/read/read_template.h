// From a template's TOML to a Template, every error with file, line and column.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "generator/template/template.h"

namespace pomona {

/// Reads and checks a template. `file` is the name used in messages.
/// \throws Error (bad_data) with all that is wrong, unknown keys included, ordered by position.
Template parse_template(std::string_view toml, const std::string& file);

/// The same from disk. \throws Error (input_missing) if it cannot be read.
Template read_template(const std::filesystem::path& file);

}  // namespace pomona
