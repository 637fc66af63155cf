// Bytes in the format of zlib (RFC 1950), which browsers, Node and every engine can unpack.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace pomona {

/// \param effort 1: fast, 9: as small as zlib makes it
std::string deflated(std::string_view bytes, int effort = 9);

/// Nothing if `packed` is not exactly one whole stream of zlib, or holds more than `max` bytes.
std::optional<std::string> inflated(std::string_view packed, std::size_t max);

}  // namespace pomona
