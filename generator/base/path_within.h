// Paths that input files name: they may lead only to files in the same folder or below.
#pragma once

#include <filesystem>
#include <optional>

namespace pomona {

/// The path from the folder ("" = the current one) to the file, with symbolic links followed; nothing if it leads out
/// of the folder. The file need not exist.
std::optional<std::filesystem::path> path_within(const std::filesystem::path& folder,
                                                 const std::filesystem::path& file);

}  // namespace pomona
