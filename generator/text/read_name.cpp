#include "generator/text/read_name.h"

#include <algorithm>

namespace pomona {

bool is_plain_name(const std::string& name) {
  const auto plain = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_'; };
  return !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), plain);
}

std::string read_name(const TomlValue& value, const std::vector<std::string>& taken) {
  const std::string name = value.text();
  if (!value.is(TomlNode::Kind::string)) return name;
  if (!is_plain_name(name)) {
    value.error("\"" + name.substr(0, 40) + "\" is not a plain name", "use a-z, 0-9, - and _, at most 64 of them");
  } else if (std::find(taken.begin(), taken.end(), name) != taken.end()) {
    value.error("\"" + name + "\" is there already", "give it a name of its own");
  }
  return name;
}

}  // namespace pomona
