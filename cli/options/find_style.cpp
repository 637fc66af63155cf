#include "cli/options/find_style.h"

#include <map>

#include "cli/options/file_kind.h"
#include "cli/options/program_folders.h"
#include "generator/base/beside.h"
#include "render/style/style_file.h"

namespace fs = std::filesystem;

namespace pomona {

Style find_style(const std::string& name_or_path) {
  if (is_style_path(name_or_path)) {
    const fs::path file = existing_file(name_or_path);
    check_kind(file, FileKind::style);
    return read_style(file);
  }
  std::error_code ignored;
  for (const fs::path& folder : searched_folders("styles")) {
    const fs::path file = folder / (name_or_path + ".toml");
    if (fs::is_regular_file(file, ignored) && is_style_file(file)) return read_style(file);
  }
  return style_named(name_or_path);
}

std::vector<Style> all_known_styles() {
  std::map<std::string, Style> styles;
  for (const fs::path& folder : searched_folders("styles")) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
      const std::string name = entry.path().stem().string();
      if (!styles.contains(name) && is_style_file(entry.path())) styles.emplace(name, read_style(entry.path()));
    }
  }
  for (Style& style : all_styles()) styles.try_emplace(style.name, style);
  std::vector<Style> result;
  for (auto& [name, style] : styles) result.push_back(std::move(style));
  return result;
}

}  // namespace pomona
