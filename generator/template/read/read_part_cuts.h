// Reads what knives do to parts.
#pragma once

#include <vector>

#include "generator/template/template.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// What knives do to parts that they do not simply go through, ascending.
struct PartCuts {
  std::vector<int> spared;  ///< are left whole
  std::vector<int> held;    ///< stay on what they lie against
};

/// Reads [part]. A spared part must lie behind a sharp surface that closes around it, so the template's surfaces and
/// grains must be known already.
PartCuts read_part_cuts(const TomlTable& table, const Template& fruit);

}  // namespace pomona
