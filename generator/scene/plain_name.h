// Names that may stand in files' names: of scenes, batches and their entries.
#pragma once

#include <string>

#include "generator/template/read/toml_document.h"

namespace pomona {

/// a-z, 0-9, - and _, at most 64 of them; notes an error at the value if it is another text.
std::string read_plain_name(const TomlValue& value, const std::string& fallback = {});

}  // namespace pomona
