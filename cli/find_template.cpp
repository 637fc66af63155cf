#include "cli/find_template.h"

#include <map>

#include "cli/program_folders.h"
#include "generator/base/error.h"
#include "generator/base/nearest_name.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

bool is_path(const std::string& text) {
  return text.find('/') != std::string::npos || text.ends_with(".toml") || text.ends_with(".ply");
}

}  // namespace

std::vector<fs::path> template_folders() { return searched_folders("templates"); }

std::vector<fs::path> all_templates() {
  std::map<std::string, fs::path> by_name;
  for (const fs::path& folder : program_folders("templates")) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
      if (entry.path().extension() == ".toml") by_name.try_emplace(entry.path().stem().string(), entry.path());
    }
  }
  std::vector<fs::path> files;
  for (const auto& [name, file] : by_name) files.push_back(file);
  return files;
}

fs::path existing_file(const std::string& path) {
  std::error_code ignored;
  if (fs::is_regular_file(path, ignored)) return path;
  throw Error(ExitStatus::input_missing, {{{path, 0, 0, {}}, "there is no such file", {}}});
}

fs::path find_template(const std::string& name_or_path) {
  if (is_path(name_or_path)) return existing_file(name_or_path);
  std::error_code ignored;
  for (const fs::path& folder : template_folders()) {
    const fs::path file = folder / (name_or_path + ".toml");
    if (fs::is_regular_file(file, ignored)) return file;
  }

  std::vector<std::string> known;
  for (const fs::path& file : all_templates()) known.push_back(file.stem().string());
  const auto near = nearest_name(name_or_path, known);
  throw Error(ExitStatus::input_missing, "there is no template \"" + name_or_path + "\"",
              near ? "did you mean " + *near + "?" : "`pomona list` prints all names; a path works too");
}

}  // namespace pomona
