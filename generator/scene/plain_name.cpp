#include "generator/scene/plain_name.h"

#include <algorithm>

namespace pomona {

namespace {

bool is_plain_name(const std::string& name) {
  const auto plain = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_'; };
  return !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), plain);
}

}  // namespace

std::string read_plain_name(const TomlValue& value, const std::string& fallback) {
  const std::string name = value.text(fallback);
  if (value.is(TomlNode::Kind::string) && !is_plain_name(name))
    value.error("\"" + name.substr(0, 40) + "\" is not a plain name", "use a-z, 0-9, - and _, at most 64 of them");
  return name;
}

}  // namespace pomona
