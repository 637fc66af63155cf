// Names in the headers of PLY files.
#pragma once

#include <algorithm>
#include <string>

namespace pomona {

/// A name is what is left of a header's line: nothing in it may end that line.
inline std::string one_line(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return name;
}

}  // namespace pomona
