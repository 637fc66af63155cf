#include "generator/base/printable.h"

namespace pomona {

std::string printable(std::string_view text) {
  constexpr char hex[] = "0123456789abcdef";
  std::string shown;
  const auto spell = [&](unsigned char byte) { shown += std::string("\\x") + hex[byte >> 4] + hex[byte & 15]; };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
    if (byte == 0xc2 && next >= 0x80 && next < 0xa0) {
      spell(next);
      ++i;
    } else if ((byte >= 0x20 && byte != 0x7f) || byte == '\n' || byte == '\t') {
      shown += text[i];
    } else {
      spell(byte);
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
