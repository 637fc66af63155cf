// The files that a template names: they lie in its folder or below.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "generator/text/toml_document.h"

namespace pomona {

/// The path of the file that the value names, in `folder` (the template's) or below; nothing if it leads elsewhere,
/// which is noted at the value.
std::optional<std::filesystem::path> file_beside(const TomlValue& value, const std::filesystem::path& folder);

/// The file that may be meant by one that is not there, or where to put it.
std::string hint_for_missing(const std::filesystem::path& file);

/// All bytes of the file that the value names; nothing if it cannot be read, or has more than `max` bytes, which is
/// noted at the value. \param smaller how to make such a file smaller, for the hint.
std::optional<std::string> bytes_beside(const TomlValue& value, const std::filesystem::path& file, std::size_t max,
                                        const std::string& smaller);

}  // namespace pomona
