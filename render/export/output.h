// Putting files where the user wants them, whole or not at all.
#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace pomona {

struct OutputFile {
  std::filesystem::path path;
  std::string bytes;
};

/// Writes every file beside its destination, down to the disk, and only when all are there puts them into place by
/// renaming. If anything fails before that, no destination has changed and nothing is left behind. What is there
/// and is no ordinary file (a device, a pipe) is written to directly.
/// \throws Error (cannot_create) where a file cannot be made, (io_error) where it cannot be written.
void write_whole(std::span<const OutputFile> files);

/// For a single file.
void write_whole(const std::filesystem::path& path, std::string bytes);

}  // namespace pomona
