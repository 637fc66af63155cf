// Names in the headers of PLY files.
#pragma once

#include <algorithm>
#include <string>

namespace pomona {

/// The name without line breaks: in a PLY header, a name is the rest of a line.
inline std::string one_line(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return name;
}

}  // namespace pomona
