// What files say, on its way to a terminal.
#pragma once

#include <string>
#include <string_view>

namespace pomona {

/// Control characters, those of UTF-8 (U+0080 to U+009F) too, spelt out as "\x1b"; line ends and tabs stay. No file can
/// move the cursor, clear the screen or name the window.
std::string printable(std::string_view text);

}  // namespace pomona
