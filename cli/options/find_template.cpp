#include "cli/options/find_template.h"

#include <map>
#include <set>
#include <system_error>

#include "cli/options/file_kind.h"
#include "generator/base/error.h"

namespace pomona {

std::filesystem::path find_template(const std::string& name_or_path) { return find_file("templates", name_or_path); }

std::vector<std::filesystem::path> all_templates() {
  std::vector<std::filesystem::path> files = own_files("templates");
  if (files.empty()) {
    throw Error(ExitStatus::input_missing, "the program's templates are not there", where_looked("templates"));
  }
  return files;
}

std::vector<std::filesystem::path> own_templates() {
  std::set<std::string> hidden;
  for (const std::filesystem::path& file : own_files("templates")) hidden.insert(file.stem().string());
  std::map<std::string, std::filesystem::path> by_name;
  for (const std::filesystem::path& folder : {std::filesystem::path("templates"), std::filesystem::path(".")}) {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
      const std::string name = entry.path().stem().string();
      if (!hidden.contains(name) && kind_of(entry.path()) == FileKind::fruit) by_name.try_emplace(name, entry.path());
    }
  }
  std::vector<std::filesystem::path> files;
  for (const auto& [name, file] : by_name) files.push_back(file);
  return files;
}

}  // namespace pomona
