#include "generator/base/millimetres.h"

#include <array>
#include <charconv>

namespace pomona {

std::string in_millimetres(double length) {
  std::array<char, 32> text{};
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), 1000 * length, std::chars_format::general, 3);
  return std::string(text.data(), error == std::errc() ? end : text.data()) + " mm";
}

}  // namespace pomona
