// Words as /bin/sh reads them.
#pragma once

#include <span>
#include <string>

namespace pomona {

/// One word for the shell, whatever its bytes: in single quotes, inside which only the single quote has a meaning.
std::string shell_quoted(const std::string& word);

/// The same for people to read: quoted only if the shell would read it as something else.
std::string shell_word(const std::string& word);

/// Words separated by spaces, each quoted.
std::string shell_line(std::span<const std::string> words);

}  // namespace pomona
