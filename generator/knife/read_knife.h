// A knife as a scene or a batch file names it.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "generator/knife/knife.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// As parse_knife() reads it; what is wrong with it is noted at the value, and nothing comes back. Files that knives
/// name are looked for from `folder`.
std::optional<Knife> read_knife(const TomlValue& value, const std::filesystem::path& folder);

/// Those of them that can be read.
std::vector<Knife> read_knives(std::span<const TomlValue> values, const std::filesystem::path& folder);

}  // namespace pomona
