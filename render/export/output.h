// Putting files where the user wants them, whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "render/export/spooled_bytes.h"

namespace pomona {

struct OutputFile {
  std::filesystem::path path;
  std::string bytes;
  std::shared_ptr<const SpooledBytes> rest = {};  ///< what comes after these, where there is more
};

/// Of all of it.
std::size_t size_of(const OutputFile& file);

/// Writes every file beside its destination, down to the disk, and only when all are there puts them into place by
/// renaming. If anything fails, renaming included, all destinations are as they were and nothing is left behind. If
/// the process is killed, each file is whole, old or new, and the next run that writes into that folder puts the
/// rest into place, too, or clears it away. A file that is replaced keeps its permissions. What is there and is no
/// ordinary file (a device, a pipe) is written to directly, as is standard output, whose path is "-".
/// \throws Error (cannot_create) where a file cannot be made, (io_error) where it cannot be written, (usage) where two
/// are the same file, links followed: one of them would be lost.
void write_whole(std::span<const OutputFile> files);

/// Whether two paths lead to one place, links followed, be a file there or not.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// For a single file.
void write_whole(const std::filesystem::path& path, std::string bytes);

}  // namespace pomona
