// Reads what knives do to parts.
#pragma once

#include <vector>

#include "generator/template/template.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// [part]: those that knives leave whole, ascending. A part must lie behind a sharp surface that closes around it,
/// which the template's surfaces and grains must already tell.
std::vector<int> read_spared(const TomlTable& table, const Template& fruit);

}  // namespace pomona
