// Text as it stands in XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace pomona {

/// With &, <, > and " as entities and control characters, line breaks too, as spaces: fit for content and for
/// attributes in double quotes.
std::string xml_escaped(std::string_view text);

}  // namespace pomona
