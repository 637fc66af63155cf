// Files of other people, read whole where they are no longer than a limit.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace pomona {

/// Why this is no file that can be read: "there is no such file", "is a folder, not a file", "is a device or a pipe,
/// not a file"; empty for a file, which may still not be permitted.
std::string why_no_file(const std::filesystem::path& file);

/// All bytes of a file. Its size is known before memory is set aside, devices and pipes are not opened, and no more is
/// read than `most` bytes even where the file grows meanwhile.
/// \throws Error (input_missing) that says why it cannot be read, (bad_data) beyond `most`, with this hint, (io_error)
/// if the disk fails.
std::string file_bytes(const std::filesystem::path& file, std::size_t most, const std::string& hint = {});

/// The first `most` bytes of a file, for who asks what kind of file it is; nothing where it cannot be read.
std::string readable_bytes(const std::filesystem::path& file, std::size_t most);

}  // namespace pomona
