#include "generator/knife/parse_knife.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "generator/base/nearest_name.h"
#include "generator/knife/knife_kinds.h"
#include "generator/knife/knife_options.h"

namespace pomona {

namespace {

/// \throws BadKnife if there is none, with the most similar name.
const KnifeKind& kind_called(const std::string& name) {
  std::vector<std::string> names;
  for (const KnifeKind& kind : knife_kinds()) {
    if (kind.name == name) return kind;
    names.push_back(kind.name);
  }
  const std::optional<std::string> meant = nearest_name(name, names);
  const std::string question = meant ? "did you mean \"" + kind_called(*meant).written.front() + "\"? " : "";
  throw BadKnife("is not one this program has", question + "a knife is one of: " + known_knives());
}

KnifeCut parse_cut(std::string_view text, const std::filesystem::path& folder) {
  const std::size_t colon = text.find(':');
  const bool has_value = colon != std::string_view::npos;
  const KnifeKind& kind = kind_called(std::string(text.substr(0, colon)));
  if (has_value && !kind.takes_value()) throw BadKnife("has a value, which " + kind.name + " does not take");
  return kind.read(kind, has_value ? text.substr(colon + 1) : std::string_view(), folder);
}

/// How a knife of this kind is written; for an unknown kind, all kinds.
std::string hint_for(std::string_view text) {
  for (const KnifeKind& kind : knife_kinds())
    if (kind.name == text.substr(0, text.find(':'))) return "it is written " + written_with_options(kind);
  return "a knife is one of: " + known_knives();
}

}  // namespace

Knife parse_knife(std::string_view text, const std::filesystem::path& folder) {
  try {
    return {parse_cut(text, folder), std::string(text)};
  } catch (const BadKnife& bad) {
    refuse_knife(text, bad.what(), bad.hint.empty() ? hint_for(text) : bad.hint);
  }
}

}  // namespace pomona
