// Reads keys of batch files and data sets that take one value or a list of alternatives.
#pragma once

#include <vector>

#include "generator/text/toml_document.h"

namespace pomona {

/// A list of values, or one value alone; nothing where the key is not given. An empty list is noted as an error.
std::vector<TomlValue> one_or_many(const TomlValue& value);

}  // namespace pomona
