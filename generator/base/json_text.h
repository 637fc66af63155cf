// JSON as text.
#pragma once

#include <string>

namespace pomona {

/// Bytes that are not UTF-8 become U+FFFD: file names may contain them, JSON may not.
/// \param indent spaces per level; below 0 = all on one line.
template <typename Json>
std::string json_text(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

/// The same for a script element of a page: nothing in it ends the element or begins a comment.
template <typename Json>
std::string json_in_script(const Json& json) {
  std::string safe;
  for (const char c : json_text(json)) safe += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return safe;
}

}  // namespace pomona
