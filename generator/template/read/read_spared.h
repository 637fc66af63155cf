// Reads what knives do to parts.
#pragma once

#include <vector>

#include "generator/template/template.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// Reads [part]: the parts that knives leave whole, ascending. Such a part must lie behind a sharp surface that closes
/// around it, so the template's surfaces and grains must be known already.
std::vector<int> read_spared(const TomlTable& table, const Template& fruit);

}  // namespace pomona
