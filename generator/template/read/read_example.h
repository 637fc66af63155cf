// Reads the picture that a [[detail]] of kind "example" names.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>

#include "generator/template/example_tile.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// The largest file of such a picture.
constexpr std::size_t max_example_bytes = std::size_t{1} << 20;

/// Reads the cube of a PNG in `folder` (the template's) or below: slices of n x n texels one below the other, n times
/// as tall as wide. Null if it is none, which is noted at the value.
std::shared_ptr<const ExampleTile> read_example(const TomlValue& value, const std::filesystem::path& folder);

}  // namespace pomona
