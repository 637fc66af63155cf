#include "cli/sketch/copied_fruit.h"

#include <algorithm>
#include <sstream>
#include <string_view>

#include "generator/base/error.h"
#include "generator/base/file_bytes.h"
#include "generator/template/read/read_template.h"
#include "generator/template/template.h"
#include "generator/text/toml_text.h"
#include "render/plate/plate.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

/// Whether the line gives this key a value.
bool gives(std::string_view line, std::string_view key) {
  if (!line.starts_with(key)) return false;
  const std::size_t next = line.find_first_not_of(" \t", key.size());
  return next != std::string_view::npos && line[next] == '=';
}

/// The text between the first quotes of a line.
std::string in_quotes(const std::string& line) {
  const std::size_t open = line.find('"'), close = line.find('"', open + 1);
  return close == std::string::npos ? std::string() : line.substr(open + 1, close - open - 1);
}

}  // namespace

StartingSketch copied_fruit(const fs::path& original, const std::string& name) {
  const Template fruit = read_template(original);
  if (!fruit.meshes.empty())
    throw Error(ExitStatus::usage, fruit.name + " is made of meshes in files of their own",
                "docs/guides/import.md begins one");
  if (!fruit.places.empty())
    throw Error(ExitStatus::usage, fruit.name + " places templates in files of their own",
                "copy its file and theirs, or begin with one that places none");

  // The lines before the first table are the fruit's own; their comments describe the original.
  StartingSketch copy;
  std::istringstream lines(read_toml_text(original));
  bool is_head = true;
  for (std::string line; std::getline(lines, line);) {
    is_head = is_head && !line.starts_with("[");
    const bool is_schema = line.starts_with("#:schema");
    if (is_head && (gives(line, "latin") || (line.starts_with("#") && !is_schema))) continue;
    if (is_head && gives(line, "name")) line = "name = \"" + name + "\"";
    if (is_head && gives(line, "title")) line = "title = \"" + words_of(name) + "\"";
    if (is_head && gives(line, "sketch")) {
      constexpr std::size_t max = std::size_t{64} << 20;
      copy.svg = file_bytes(original.parent_path() / in_quotes(line), max);
      line = "sketch = \"" + name + ".svg\"";
    }
    if (gives(line, "example")) {
      const fs::path picture = original.parent_path() / in_quotes(line);
      if (std::find(copy.examples.begin(), copy.examples.end(), picture) == copy.examples.end())
        copy.examples.push_back(picture);
      line = "example = \"" + picture.filename().string() + "\"";
    }
    copy.toml += line + "\n";
    if (is_schema) copy.toml += "# Begun as a copy of " + fruit.name + ".\n";
  }
  return copy;
}

}  // namespace pomona
