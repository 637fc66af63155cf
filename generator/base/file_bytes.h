// Reads a whole file, if it is not larger than a limit.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace pomona {

/// Why this is no file that can be read: "there is no such file", "is a folder, not a file", "is a device or a pipe,
/// not a file"; empty for a file, which may still not be permitted.
std::string why_no_file(const std::filesystem::path& file);

/// "did you mean b.png?", if a file of nearly this name lies in the same folder, with the same ending; else empty.
std::string near_file_hint(const std::filesystem::path& missing);

/// All bytes of a file. Its size is checked before memory is allocated; devices and pipes are not opened; never more
/// than `max` bytes are read, even if the file grows meanwhile. \throws Error (input_missing) that says why it cannot
/// be read, (bad_data) with this hint if it is larger than `max`, (io_error) if the disk fails.
std::string file_bytes(const std::filesystem::path& file, std::size_t max, const std::string& hint = {});

/// The first `max` bytes of a file, to find out its kind; empty if it cannot be read.
std::string readable_bytes(const std::filesystem::path& file, std::size_t max);

}  // namespace pomona
