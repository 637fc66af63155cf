// Reads a knife from a scene or batch file.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "generator/knife/knife.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// The knife, as parse_knife() reads it. If it is not valid, notes the error at the value and returns nothing. Relative
/// paths start from `folder`.
std::optional<Knife> read_knife(const TomlValue& value, const std::filesystem::path& folder);

/// The knives of these that are valid.
std::vector<Knife> read_knives(std::span<const TomlValue> values, const std::filesystem::path& folder);

}  // namespace pomona
