#include "cli/find_template.h"

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

}  // namespace pomona
