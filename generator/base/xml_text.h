// Text for XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace pomona {

/// The text with &, <, > and " as entities, and with control characters and line breaks as spaces, and with U+FFFD for
/// what is no UTF-8: for content and for attributes in double quotes.
std::string xml_escaped(std::string_view text);

}  // namespace pomona
