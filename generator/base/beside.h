// Paths in a file start at its folder; paths in commands start at the folder of the file that they make again.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "generator/base/error.h"

namespace pomona {

/// The file that `file` names by a path from its folder, if it is there.
std::optional<std::filesystem::path> found_beside(const std::filesystem::path& file, const std::string& path);

/// Whether a style is given by its path: it has a folder or the ending .toml.
bool is_style_path(const std::string& name_or_path);

/// A style that `file` names, as the command line takes it: a path is from the current folder.
std::string style_beside(const std::filesystem::path& file, const std::string& style);

/// A path of the command line as a word of a command that is typed in the folder. An absolute one keeps its name alone,
/// so that nothing tells of the machine. "" is the current folder.
std::string word_from(const std::filesystem::path& folder, const std::string& path);

/// An error about something that a file names, told where it is named.
Error told_where_named(const Error& error, const SourcePlace& place);

}  // namespace pomona
