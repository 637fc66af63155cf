#include "generator/text/toml_text.h"

#include <algorithm>
#include <sstream>

#include "generator/base/file_bytes.h"
#include "generator/base/small_ending.h"
#include "generator/text/toml_limits.h"

namespace pomona {

std::string read_toml_text(const std::filesystem::path& file) {
  return file_bytes(file, TomlLimits{}.bytes, "no such file is that long");
}

bool has_toml_heading(const std::filesystem::path& file, std::initializer_list<std::string_view> headings,
                      std::initializer_list<std::string_view> without) {
  if (small_ending(file) != ".toml") return false;
  std::istringstream text(readable_bytes(file, TomlLimits{}.bytes));
  bool found = false;
  for (std::string line; std::getline(text, line);) {
    line.erase(0, line.find_first_not_of(" \t"));
    const auto begins = [&](std::string_view heading) { return line.starts_with(heading); };
    if (std::any_of(without.begin(), without.end(), begins)) return false;
    found = found || std::any_of(headings.begin(), headings.end(), begins);
  }
  return found;
}

}  // namespace pomona
