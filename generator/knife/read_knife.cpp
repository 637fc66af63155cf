#include "generator/knife/read_knife.h"

#include "generator/knife/parse_knife.h"

namespace pomona {

std::optional<Knife> read_knife(const TomlValue& value, const std::filesystem::path& folder) {
  const std::string text = value.text();
  if (!value.is(TomlNode::Kind::string)) return {};
  try {
    return parse_knife(text, folder);
  } catch (const Error& error) {
    // A mistake in a drawing has a place in that file.
    const Diagnostic& what = error.diagnostics().front();
    const bool elsewhere = !what.place.file.empty();
    value.error(elsewhere ? to_string({what.place, what.message, {}}) : what.message, what.hint);
    return {};
  }
}

std::vector<Knife> read_knives(std::span<const TomlValue> values, const std::filesystem::path& folder) {
  std::vector<Knife> knives;
  for (const TomlValue& value : values) {
    if (const std::optional<Knife> knife = read_knife(value, folder)) knives.push_back(*knife);
  }
  return knives;
}

}  // namespace pomona
