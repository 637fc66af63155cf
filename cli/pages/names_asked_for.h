// Values that only the program knows when it runs.
#pragma once

#include <string>

namespace pomona {

/// The shell's words that print the names a value may be, one a line; nothing for values of other kinds.
inline std::string names_asked_for(const std::string& value) {
  if (value == "TEMPLATE") return "pomona list 2>/dev/null | cut -f1";
  if (value == "SCENE") return "pomona list --scenes 2>/dev/null | cut -f1";
  if (value == "BATCH") return "pomona list --batches 2>/dev/null | cut -f1";
  if (value == "STYLE") return "pomona list --styles 2>/dev/null | cut -f1";
  return "";
}

}  // namespace pomona
