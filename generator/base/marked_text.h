// A text with marks, "@NAME@", of which a page is made.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pomona {

/// `text` with each mark replaced; what replaces one is not looked through for others.
std::string filled(std::string_view text, const std::vector<std::pair<std::string_view, std::string>>& marks);

}  // namespace pomona
