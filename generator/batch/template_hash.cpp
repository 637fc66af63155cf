#include "generator/batch/template_hash.h"

#include <fstream>
#include <iterator>
#include <set>

#include "generator/base/path_within.h"
#include "generator/base/sha256.h"
#include "generator/text/toml_node.h"
#include "generator/text/toml_text.h"

namespace pomona {

namespace {

namespace fs = std::filesystem;

/// Every text in the tree that is the name of a file beside the template, or below. Names come sorted.
void add_named_files(const TomlNode& node, const fs::path& folder, std::set<std::string>& names) {
  constexpr std::size_t longest_name = 255;
  if (node.kind == TomlNode::Kind::string && !node.text.empty() && node.text.size() <= longest_name) {
    std::error_code ignored;
    const bool is_relative = !fs::path(node.text).is_absolute();
    if (is_relative && fs::is_regular_file(folder / node.text, ignored) && path_within(folder, folder / node.text))
      names.insert(node.text);
  }
  for (const TomlNode& item : node.items) add_named_files(item, folder, names);
  for (const TomlEntry& entry : node.entries) add_named_files(entry.value, folder, names);
}

/// The name, the length and the bytes: no two lists of files come to the same text.
std::string block(const std::string& name, const std::string& bytes) {
  return name + "\n" + std::to_string(bytes.size()) + "\n" + bytes;
}

}  // namespace

std::string template_hash(const fs::path& file) {
  const std::string toml = read_toml_text(file);
  std::set<std::string> names;
  add_named_files(parse_toml(toml, file.string()), file.parent_path(), names);

  std::string all = block(file.filename().string(), toml);
  for (const std::string& name : names) {
    std::ifstream stream(file.parent_path() / name, std::ios::binary);
    all += block(name, {std::istreambuf_iterator<char>(stream), {}});
  }
  return sha256(all);
}

}  // namespace pomona
