#include "generator/base/base64.h"

#include <nettle/base64.h>

#include <cstdint>

namespace pomona {

std::string base64(std::string_view bytes) {
  std::string text(BASE64_ENCODE_RAW_LENGTH(bytes.size()), '\0');
  base64_encode_raw(text.data(), bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
  return text;
}

std::optional<std::string> base64_decoded(std::string_view text) {
  // Nettle would ask for padding; files in the wild leave it out.
  std::string digits(text);
  std::erase(digits, '=');
  std::string bytes(BASE64_DECODE_LENGTH(digits.size()), '\0');
  std::size_t length = bytes.size();
  base64_decode_ctx decoder;
  base64_decode_init(&decoder);
  if (!base64_decode_update(&decoder, &length, reinterpret_cast<std::uint8_t*>(bytes.data()), digits.size(),
                            digits.data()))
    return {};
  bytes.resize(length);
  return bytes;
}

}  // namespace pomona
