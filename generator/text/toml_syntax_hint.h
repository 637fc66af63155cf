// What was probably meant where a text is no TOML: people forget quotes.
#pragma once

#include <string>
#include <string_view>

#include "generator/text/toml_node.h"

namespace pomona {

/// How to write it instead; empty if nobody can tell. \param fault toml++'s description of what is wrong at `place`.
std::string toml_syntax_hint(std::string_view text, TomlPlace place, std::string_view fault);

}  // namespace pomona
