// Reads names in template, scene and batch files.
#pragma once

#include <string>
#include <vector>

#include "generator/text/toml_document.h"

namespace pomona {

/// True for a name that may stand in files' names and messages: a-z, 0-9, - and _, at most 64 of them.
bool is_plain_name(const std::string& name);

/// Reads a plain name that must differ from those in `taken`.
std::string read_name(const TomlValue& value, const std::vector<std::string>& taken);

}  // namespace pomona
