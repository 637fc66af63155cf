// Names of surfaces, parts and grains as template files spell them.
#pragma once

#include <string>
#include <vector>

#include "generator/template/read/toml_document.h"

namespace pomona {

/// A name for files and messages: a-z, 0-9, - and _, at most 64 of them; `taken` are those it must differ from.
std::string read_name(const TomlValue& value, const std::vector<std::string>& taken);

}  // namespace pomona
