#include "cli/options/program_folders.h"

#include <algorithm>
#include <map>

#include "generator/base/error.h"
#include "generator/base/file_bytes.h"
#include "generator/base/nearest_name.h"
#include "generator/base/small_ending.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

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
  if (!why.empty()) throw Error(ExitStatus::input_missing, {{{path, 0, 0, {}}, why, {}}});
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

  // The name is unknown; report a file or folder of this name in the current folder.
  std::error_code ignored;
  if (fs::exists(name_or_path, ignored)) {
    const fs::path file = existing_file(name_or_path);
    throw Error(ExitStatus::bad_data,
                {{{file.string(), 1, 1, {}}, "has no ending of a file that is read here", "name it FILE.toml"}});
  }

  std::vector<std::string> known;
  for (const fs::path& file : own_files(kind)) known.push_back(file.stem().string());
  const auto near = nearest_name(name_or_path, known);
  const std::string what = called.empty() ? kind.substr(0, kind.size() - 1) : called;
  throw Error(ExitStatus::input_missing, "there is no " + what + " \"" + name_or_path + "\"",
              near ? "did you mean " + *near + "?" : where_looked(kind) + "; a path works too");
}

}  // namespace pomona
