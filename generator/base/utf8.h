// Whether bytes are UTF-8, and which characters. Names of files may be any bytes; most formats hold UTF-8 alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace pomona {

/// Length of the character that the text begins with, in bytes (RFC 3629: no overlong forms, no surrogates); 0 if it
/// begins with none.
std::size_t utf8_length(std::string_view text);

/// The code point of one character: all bytes that utf8_length() counts.
std::uint32_t utf8_code(std::string_view character);

/// The text with U+FFFD for every byte that belongs to no character.
std::string as_utf8(std::string_view text);

}  // namespace pomona
