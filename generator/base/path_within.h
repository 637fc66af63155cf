// Paths that files name: they may lead to what lies beside these files or below, and nowhere else.
#pragma once

#include <filesystem>
#include <optional>

namespace pomona {

/// The way from the folder ("" = the current one) to the file, with symbolic links followed; nothing if it leads out.
/// The file need not exist.
std::optional<std::filesystem::path> path_within(const std::filesystem::path& folder,
                                                 const std::filesystem::path& file);

}  // namespace pomona
