// Reads the [[detail]] tables of a template file.
#pragma once

#include <vector>

#include "generator/template/template.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// Needs the fruit's parts and surfaces, so read these first.
std::vector<DetailSketch> read_details(const TomlValue& value, const Template& fruit);

}  // namespace pomona
