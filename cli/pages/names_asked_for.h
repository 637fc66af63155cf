// Values that the program knows only when it runs.
#pragma once

#include <string>

namespace pomona {

/// The shell command that prints the possible names of a value, one per line; empty for other values.
inline std::string names_asked_for(const std::string& value) {
  if (value == "TEMPLATE") return "pomona list 2>/dev/null | cut -f1";
  if (value == "SCENE") return "pomona list --scenes 2>/dev/null | cut -f1";
  if (value == "BATCH") return "pomona list --batches 2>/dev/null | cut -f1";
  if (value == "STYLE") return "pomona list --styles 2>/dev/null | cut -f1";
  return "";
}

}  // namespace pomona
