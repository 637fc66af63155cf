#include "generator/template/read/toml_text.h"

#include <algorithm>
#include <fstream>

#include "generator/base/error.h"
#include "generator/base/first_bytes.h"
#include "generator/template/read/toml_limits.h"

namespace pomona {

std::string read_toml_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file))
    throw Error(ExitStatus::input_missing, {{{file.string(), 0, 0, {}}, "cannot be read", {}}});
  std::string text = first_bytes(stream, TomlLimits{}.bytes + 1);
  if (stream.bad()) throw Error(ExitStatus::io_error, {{{file.string(), 0, 0, {}}, "cannot be read to its end", {}}});
  return text;
}

bool has_toml_heading(const std::filesystem::path& file, std::initializer_list<std::string_view> headings) {
  if (file.extension() != ".toml") return false;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    line.erase(0, line.find_first_not_of(" \t"));
    const auto begins = [&](std::string_view heading) { return line.starts_with(heading); };
    if (std::any_of(headings.begin(), headings.end(), begins)) return true;
  }
  return false;
}

}  // namespace pomona
