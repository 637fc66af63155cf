// The kind of a text file that people write, so that a command can name the right one.
#pragma once

#include <filesystem>
#include <string>

namespace pomona {

enum class FileKind { fruit, scene, batch, data, style, other };

/// The kind by its headings; `other` for all other files.
FileKind kind_of(const std::filesystem::path& file);

/// What a file of this kind is, and which command takes it.
struct KindWords {
  std::string what, taken_by;
};
KindWords words_of(FileKind kind);

/// Refuses a file of another kind than wanted, in one line that names the command which takes it.
/// \throws Error (bad_data)
void check_kind(const std::filesystem::path& file, FileKind wanted);

}  // namespace pomona
