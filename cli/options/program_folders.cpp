#include "cli/options/program_folders.h"

#include <algorithm>
#include <array>
#include <map>

#include "cli/options/file_kind.h"
#include "generator/base/error.h"
#include "generator/base/file_bytes.h"
#include "generator/base/nearest_name.h"
#include "generator/base/shell_words.h"
#include "generator/base/small_ending.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

/// Where the program's own files lie that people write.
constexpr std::array folders_of_files = {"templates", "scenes", "styles"};

/// All folders, in the order in which they are searched.
std::vector<fs::path> candidates(const std::string& kind) {
  std::vector<fs::path> folders = program_folders(kind);
  folders.insert(folders.end(), {kind, "."});
  return folders;
}

/// Whether a word is a path: it has a folder, or the ending of a file that is read, in capitals or small letters.
bool is_path(const std::string& text) {
  for (const char* ending : {".toml", ".ply", ".obj", ".glb", ".svg", ".json", ".png"})
    if (small_ending(text) == ending) return true;
  return text.find('/') != std::string::npos;
}

std::vector<std::string> stems_of(const std::vector<fs::path>& files) {
  std::vector<std::string> names;
  for (const fs::path& file : files) names.push_back(file.stem().string());
  return names;
}

/// The program's own file of this name, of whatever kind.
std::optional<fs::path> own_file_called(const std::string& name) {
  for (const char* kind : folders_of_files)
    for (const fs::path& file : own_files(kind))
      if (file.stem() == name) return file;
  return std::nullopt;
}

/// The file beside a missing one that may be meant, or the name of one of the program's own.
std::string hint_for_absent(const fs::path& path) {
  if (const auto home = unread_home_hint(path.string())) return *home;
  std::error_code ignored;
  if (fs::exists(path, ignored)) return {};
  const std::string name = path.stem().string();
  if (!path.has_parent_path() && small_ending(path) == ".toml" && own_file_called(name))
    return "the program's own is called " + name;
  return near_file_hint(path);
}

/// Reports a file or folder of this name in the current folder, for a name that is not known.
void refuse_without_ending(const std::string& name) {
  std::error_code ignored;
  if (!fs::exists(name, ignored)) return;
  const fs::path file = existing_file(name);
  throw Error(ExitStatus::bad_data,
              {{{file.string(), 1, 1, {}}, "has no ending of a file that is read here", "name it FILE.toml"}});
}

}  // namespace

std::vector<fs::path> searched_folders(const std::string& kind) {
  std::vector<fs::path> folders;
  for (const fs::path& folder : candidates(kind)) {
    std::error_code ignored;
    if (fs::is_directory(folder, ignored)) folders.push_back(folder);
  }
  return folders;
}

std::string where_looked(const std::string& kind) {
  std::string text = "looked in ";
  for (const fs::path& folder : program_folders(kind)) text += folder.string() + ", ";
  return text + kind + "/ and the current folder";
}

std::vector<fs::path> own_files(const std::string& kind) {
  std::map<std::string, fs::path> by_name;
  for (const fs::path& folder : program_folders(kind)) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
      if (entry.path().extension() == ".toml") by_name.try_emplace(entry.path().stem().string(), entry.path());
    }
  }
  std::vector<fs::path> files;
  for (const auto& [name, file] : by_name) files.push_back(file);
  return files;
}

bool is_own_scene(const fs::path& file) {
  const std::vector<fs::path> folders = program_folders("scenes");
  return std::find(folders.begin(), folders.end(), file.parent_path()) != folders.end();
}

fs::path start_of_commands(const fs::path& file) { return is_own_scene(file) ? fs::path() : file.parent_path(); }

fs::path existing_file(const std::string& path) {
  const std::string why = why_no_file(path);
  if (!why.empty()) throw Error(ExitStatus::input_missing, {{{path, 0, 0, {}}, why, hint_for_absent(path)}});
  return path;
}

std::optional<fs::path> file_of(const std::string& kind, const std::string& name_or_path) {
  std::error_code ignored;
  if (is_path(name_or_path))
    return why_no_file(name_or_path).empty() ? std::optional<fs::path>(name_or_path) : std::nullopt;
  for (const fs::path& folder : candidates(kind)) {
    fs::path file = folder / (name_or_path + ".toml");
    if (fs::is_regular_file(file, ignored)) return file;
  }
  return std::nullopt;
}

fs::path find_file(const std::string& kind, const std::string& name_or_path, const std::string& called) {
  if (const std::optional<fs::path> file = file_of(kind, name_or_path)) return *file;
  if (is_path(name_or_path)) return existing_file(name_or_path);

  refuse_without_ending(name_or_path);
  const std::string missing =
      "there is no " + (called.empty() ? kind.substr(0, kind.size() - 1) : called) + " \"" + name_or_path + "\"";
  if (const std::optional<fs::path> other = own_file_called(name_or_path)) {
    const KindWords words = words_of(kind_of(*other));
    throw Error(ExitStatus::input_missing, missing, name_or_path + " " + words.what + ": " + words.taken_by);
  }
  const auto near = nearest_name(name_or_path, stems_of(own_files(kind)));
  throw Error(ExitStatus::input_missing, missing,
              near ? "did you mean " + *near + "?" : where_looked(kind) + "; a path works too");
}

fs::path find_any_file(const std::string& name_or_path) {
  std::vector<std::string> known;
  for (const char* kind : folders_of_files) {
    if (const std::optional<fs::path> file = file_of(kind, name_or_path)) return *file;
    for (std::string& name : stems_of(own_files(kind))) known.push_back(std::move(name));
  }
  if (is_path(name_or_path)) return existing_file(name_or_path);
  refuse_without_ending(name_or_path);
  const auto near = nearest_name(name_or_path, known);
  throw Error(ExitStatus::input_missing,
              "there is no template, scene, batch, data set or style \"" + name_or_path + "\"",
              near ? "did you mean " + *near + "?" : "`pomona list -h` tells how to list them; a path works too");
}

}  // namespace pomona
