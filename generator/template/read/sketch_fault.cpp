#include "generator/template/read/sketch_fault.h"

#include <charconv>
#include <system_error>

namespace pomona {

Diagnostic placed_fault(const BadSketch& bad, const std::string& file) {
  Diagnostic told{{file, 1, 1, {}}, bad.what(), bad.hint};
  if (!told.message.starts_with(file + ":")) return told;

  // Parses "LINE:COLUMN: message".
  const char* at = told.message.data() + file.size() + 1;
  const char* const end = told.message.data() + told.message.size();
  SourcePlace place{file, 0, 0, {}};
  for (int* number : {&place.line, &place.column}) {
    const auto [next, fault] = std::from_chars(at, end, *number);
    if (fault != std::errc() || next == end || *next != ':') return told;
    at = next + 1;
  }
  told.message.erase(0, static_cast<std::size_t>(at - told.message.data()) + 1);
  told.place = place;
  return told;
}

}  // namespace pomona
