// Words as /bin/sh reads them.
#pragma once

#include <span>
#include <string>

namespace pomona {

/// One word for the shell, whatever bytes it has: within single quotes, in which nothing has a meaning but the single
/// quote itself.
std::string shell_quoted(const std::string& word);

/// The same for people to read: quoted only where the shell would take it for something else.
std::string shell_word(const std::string& word);

/// Words parted by spaces, each quoted.
std::string shell_line(std::span<const std::string> words);

}  // namespace pomona
