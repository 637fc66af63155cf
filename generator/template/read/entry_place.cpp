#include "generator/template/read/entry_place.h"

#include "generator/base/file_bytes.h"
#include "generator/template/template.h"
#include "generator/text/toml_limits.h"
#include "generator/text/toml_node.h"

namespace pomona {

namespace {

const TomlNode* value_at(const TomlNode& table, const std::string& key) {
  for (const TomlEntry& entry : table.entries)
    if (entry.key == key) return &entry.value;
  return nullptr;
}

}  // namespace

SourcePlace entry_place(const std::string& file, const std::string& list, const std::string& name) {
  try {
    const TomlNode root = parse_toml(readable_bytes(file, TomlLimits{}.bytes), file);
    const TomlNode* entries = value_at(root, list);
    for (std::size_t i = 0; entries && i < entries->items.size(); ++i) {
      const TomlNode* named = value_at(entries->items[i], "name");
      if (named && named->text == name) return {file, named->place.line, named->place.column, {}};
    }
  } catch (const Error&) {
    // The file is not TOML any more: name it as a whole.
  }
  return {file, 0, 0, {}};
}

void refuse_entry(const Template& fruit, const std::string& list, const std::string& name, const std::string& message,
                  const std::string& hint) {
  const SourcePlace place = entry_place(fruit.file.empty() ? fruit.name : fruit.file, list, name);
  throw Error(ExitStatus::bad_data, {{place, list + " \"" + name + "\": " + message, hint}});
}

}  // namespace pomona
