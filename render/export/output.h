// Writes the outputs of a command: all of them whole, or none (crash-safe writing: transaction/).
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "render/export/transaction/spooled_bytes.h"

namespace pomona {

struct OutputFile {
  std::filesystem::path path;
  std::string bytes;
  std::shared_ptr<const SpooledBytes> rest = {};  ///< bytes that follow; null = none
};

/// The size of the whole file, bytes.
std::size_t size_of(const OutputFile& file);

/// Writes every file beside its destination, down to the disk. When all are there, renames them. If anything fails,
/// also a renaming, all destinations are as before and nothing is left behind. If the process is killed, each file is
/// whole, old or new, and the next run that writes into that folder puts the rest into place, too, or removes it. A
/// replaced file keeps its permissions. A destination that is not an ordinary file (a device, a pipe) is written to
/// directly; so is standard output, whose path is "-". \throws Error (cannot_create) if a file cannot be made,
/// (io_error) if it cannot be written, (usage) if two paths lead to the same file, links followed: one of them would be
/// lost.
void write_whole(std::span<const OutputFile> files);

/// Whether two paths lead to the same place, links followed. There need not be a file.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// The same for a single file.
void write_whole(const std::filesystem::path& path, std::string bytes);

}  // namespace pomona
