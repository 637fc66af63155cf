// The folders of the program's own files: beside it in a source tree, or installed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/program_place.h"

namespace pomona {

/// The existing ones, then a folder of that kind within the current folder, then the current folder itself.
std::vector<std::filesystem::path> searched_folders(const std::string& kind);

/// A hint if nothing of that kind is found: "looked in A, B and C".
std::string where_looked(const std::string& kind);

/// The program's own files (.toml) of that kind, sorted by name; those of an earlier folder hide later ones.
std::vector<std::filesystem::path> own_files(const std::string& kind);

/// Whether a scene, batch or data set is one of the program's own, which are found by name everywhere.
bool is_own_scene(const std::filesystem::path& file);

/// The folder at which paths start in commands that make things of the file again: its own, or "", where the program
/// is called, for the program's own.
std::filesystem::path start_of_commands(const std::filesystem::path& file);

/// The path itself.
/// \throws Error (input_missing) if there is no such file.
std::filesystem::path existing_file(const std::string& path);

/// The file that find_file() finds, if there is one. Quick for words that name none: most texts of a template do not.
std::optional<std::filesystem::path> file_of(const std::string& kind, const std::string& name_or_path);

/// The file behind a name ("tomato" is tomato.toml in searched_folders(kind)), or behind a path (it has a slash, or
/// ends in .toml or .ply).
/// \param called the word for the file, if it differs from the folder's: batches lie among the scenes.
/// \throws Error (input_missing) with the nearest known name, or with the searched folders.
std::filesystem::path find_file(const std::string& kind, const std::string& name_or_path,
                                const std::string& called = {});

/// The file behind a name of whatever kind, templates first, then scenes, batches, data sets and styles; or a path.
/// \throws Error (input_missing)
std::filesystem::path find_any_file(const std::string& name_or_path);

}  // namespace pomona
