// Names in sketches, and in messages about them.
#pragma once

#include <string>
#include <string_view>

namespace pomona {

/// A name in its common spelling: "Side View", "side_view" and "side-view" are the same.
inline std::string plain_name(std::string_view name) {
  std::string result;
  for (const char c : name) {
    if (c == ' ' || c == '_') {
      result += '-';
    } else {
      result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
  }
  return result;
}

inline std::string quoted_name(const std::string& name) { return "\"" + name.substr(0, 60) + "\""; }

}  // namespace pomona
