// The [[detail]] tables of a template file.
#pragma once

#include <vector>

#include "generator/template/read/toml_document.h"
#include "generator/template/template.h"

namespace pomona {

/// After the fruit's parts and surfaces are read.
std::vector<DetailSketch> read_details(const TomlValue& value, const Template& fruit);

}  // namespace pomona
