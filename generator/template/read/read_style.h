// Reads the [noise] and [ink] of a template file.
#pragma once

#include "generator/template/ink_style.h"
#include "generator/template/noise_style.h"
#include "generator/text/toml_document.h"

namespace pomona {

NoiseStyle read_noise(const TomlTable& table);
InkStyle read_ink(const TomlTable& table);

}  // namespace pomona
