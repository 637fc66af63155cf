// The marks with which some programs begin a text, to tell how it is written.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace pomona {

struct ByteMark {
  std::size_t size = 0;  ///< bytes
  bool is_utf8 = true;   ///< else UTF-16 or UTF-32
};

/// The mark at the beginning of a file, if it has one.
inline std::optional<ByteMark> byte_mark_of(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) return ByteMark{3, true};
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) return ByteMark{2, false};
  return {};
}

}  // namespace pomona
