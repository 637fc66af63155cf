// Bytes as text in base 64 (RFC 4648): SVG and HTML hold pictures so.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pomona {

/// Base64 in one line, with padding.
std::string base64(std::string_view bytes);

/// Ignores white space and padding. Nothing if the text has any other character that base 64 does not have.
std::optional<std::string> base64_decoded(std::string_view text);

}  // namespace pomona
