// Which of the text files that people write a file is, so that the wrong command can say so.
#pragma once

#include <filesystem>

namespace pomona {

enum class FileKind { fruit, scene, batch, style, other };

/// By the headings in it; `other` for what is none of them, or no .toml.
FileKind kind_of(const std::filesystem::path& file);

/// Refuses a file of another kind than wanted, in one line that names the command which takes it.
/// \throws Error (bad_data)
void check_kind(const std::filesystem::path& file, FileKind wanted);

}  // namespace pomona
