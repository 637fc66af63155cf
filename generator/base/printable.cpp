#include "generator/base/printable.h"

#include <algorithm>

#include "generator/base/utf8.h"

namespace pomona {

namespace {

/// Marks of direction (U+061C, U+200E, ..., U+2069), and the line and paragraph separators.
bool turns_or_breaks(unsigned code) {
  return code == 0x061c || code == 0x200e || code == 0x200f || (code >= 0x2028 && code <= 0x202e) ||
         (code >= 0x2066 && code <= 0x2069);
}

std::string in_hex(unsigned code, int digits) {
  std::string text;
  for (int i = digits - 1; i >= 0; --i) text += "0123456789abcdef"[code >> (4 * i) & 15u];
  return text;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::string_view character = text.substr(0, std::max<std::size_t>(1, utf8_length(text)));
    text.remove_prefix(character.size());
    const auto byte = static_cast<unsigned char>(character[0]);
    const bool is_several = character.size() == 2 || character.size() == 3;
    const unsigned code = is_several ? utf8_code(character) : byte;
    const bool is_whole = character.size() > 1 || byte < 0x80;
    if (is_several && turns_or_breaks(code)) {
      shown += "\\u" + in_hex(code, 4);
    } else if ((code < 0x20 && code != '\n' && code != '\t') || code == 0x7f ||
               ((is_several || !is_whole) && code >= 0x80 && code < 0xa0)) {
      shown += "\\x" + in_hex(code, 2);
    } else {
      shown += character;
    }
  }
  return shown;
}

std::string printable_line(std::string_view text) {
  std::string line;
  for (const char c : printable(text)) line += c == '\n' ? std::string("\\n") : c == '\t' ? "\\t" : std::string(1, c);
  return line;
}

}  // namespace pomona
