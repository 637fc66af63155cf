#include "generator/batch/template_hash.h"

#include <fstream>
#include <iterator>
#include <set>

#include "generator/base/error.h"
#include "generator/base/path_within.h"
#include "generator/base/sha256.h"
#include "generator/base/small_ending.h"
#include "generator/text/toml_node.h"
#include "generator/text/toml_text.h"

namespace pomona {

namespace {

namespace fs = std::filesystem;

/// Every text in the tree that is the name of a file beside the template, or below; and what templates among them name,
/// as far down as templates may be placed. Names come sorted.
void add_named_files(const TomlNode& node, const fs::path& folder, const std::string& within, int levels,
                     std::set<std::string>& names);

/// The names in a template that another one names.
void add_names_within(const std::string& name, const fs::path& folder, int levels, std::set<std::string>& names) {
  if (levels == 0 || small_ending(name) != ".toml") return;
  const fs::path file = folder / name;
  try {
    const TomlNode root = parse_toml(read_toml_text(file), file.string());
    add_named_files(root, folder, fs::path(name).parent_path().generic_string(), levels - 1, names);
  } catch (const Error&) {
    // It is no template; that it is named counts.
  }
}

void add_named_files(const TomlNode& node, const fs::path& folder, const std::string& within, int levels,
                     std::set<std::string>& names) {
  constexpr std::size_t longest_name = 255;
  if (node.kind == TomlNode::Kind::string && !node.text.empty() && node.text.size() <= longest_name) {
    std::error_code ignored;
    const bool is_relative = !fs::path(node.text).is_absolute();
    const std::string name = within.empty() ? node.text : within + "/" + node.text;
    if (is_relative && fs::is_regular_file(folder / name, ignored) && path_within(folder, folder / name)) {
      if (names.insert(name).second) add_names_within(name, folder, levels, names);
    }
  }
  for (const TomlNode& item : node.items) add_named_files(item, folder, within, levels, names);
  for (const TomlEntry& entry : node.entries) add_named_files(entry.value, folder, within, levels, names);
}

/// The name, the length and the bytes: no two lists of files come to the same text.
std::string block(const std::string& name, const std::string& bytes) {
  return name + "\n" + std::to_string(bytes.size()) + "\n" + bytes;
}

}  // namespace

std::string template_hash(const fs::path& file) {
  const std::string toml = read_toml_text(file);
  std::set<std::string> names;
  constexpr int levels = 4;
  add_named_files(parse_toml(toml, file.string()), file.parent_path(), {}, levels, names);

  std::string all = block(file.filename().string(), toml);
  for (const std::string& name : names) {
    std::ifstream stream(file.parent_path() / name, std::ios::binary);
    all += block(name, {std::istreambuf_iterator<char>(stream), {}});
  }
  return sha256(all);
}

}  // namespace pomona
