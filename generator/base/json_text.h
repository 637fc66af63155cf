// JSON as text.
#pragma once

#include <string>

namespace pomona {

/// Letters that are no UTF-8, which names of files may hold and JSON may not, become U+FFFD: a name alone does not keep
/// a file from being written. \param indent spaces a level; below 0 all on one line.
template <typename Json>
std::string json_text(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

/// For a script element of a page: nothing in it ends the element or begins a comment.
template <typename Json>
std::string json_in_script(const Json& json) {
  std::string safe;
  for (const char c : json_text(json)) safe += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return safe;
}

}  // namespace pomona
