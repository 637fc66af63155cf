// Bytes as text, base 64 (RFC 4648), as pictures lie in SVG and HTML.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pomona {

/// In one line, with padding.
std::string base64(std::string_view bytes);

/// White space and padding are passed over; none if there is any other character that base 64 does not have.
std::optional<std::string> base64_decoded(std::string_view text);

}  // namespace pomona
