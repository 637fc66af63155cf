// Text from files, made safe for a terminal.
#pragma once

#include <string>
#include <string_view>

namespace pomona {

/// The text with control characters (also U+0080 to U+009F) written as "\x1b"; line ends and tabs stay. So no file can
/// move the cursor, clear the screen or change the title of the window. Nor can it turn what follows around: marks of
/// direction, and line ends of Unicode, are written as "\u202e".
std::string printable(std::string_view text);

/// The same with line ends and tabs as "\n" and "\t", too: of what stands in one line, a name cannot make two.
std::string printable_line(std::string_view text);

}  // namespace pomona
