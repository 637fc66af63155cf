// Words as /bin/sh reads them.
#pragma once

#include <optional>
#include <span>
#include <string>

namespace pomona {

/// One word for the shell, whatever its bytes: in single quotes, inside which only the single quote has a meaning.
std::string shell_quoted(const std::string& word);

/// The same for people to read: quoted only if the shell would read it as something else.
std::string shell_word(const std::string& word);

/// What to write in place of a path that begins with "~": programs get it from `--style=~/a.toml` and from scripts, for
/// a shell reads it only at the start of a word, without quotes.
std::optional<std::string> unread_home_hint(const std::string& path);

/// Words separated by spaces, each quoted.
std::string shell_line(std::span<const std::string> words);

}  // namespace pomona
