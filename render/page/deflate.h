// Bytes in the format of zlib (RFC 1950): what browsers, Node and every engine unpack by themselves.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace pomona {

/// \param effort 1: fast, 9: as small as zlib makes it
std::string deflated(std::string_view bytes, int effort = 9);

/// Nothing if `packed` is no whole stream of zlib, something follows it, or it holds more than `max` bytes.
std::optional<std::string> inflated(std::string_view packed, std::size_t max);

}  // namespace pomona
