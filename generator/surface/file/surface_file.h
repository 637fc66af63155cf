// Surfaces as PLY: the door to and from every modelling tool (docs/reference/formats.md).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// The bytes of a binary little-endian PLY that holds everything in `surfaces`; reading it back gives equal
/// values.
std::string write_surfaces(const DiffusionSurfaces& surfaces);

/// Reads PLY tolerantly: ascii and both byte orders, polygons, extra and missing properties. Where no hidden
/// flag is there at all, the outermost closed shell counts as skin. Counts are checked against the file's
/// size before anything is allocated. `file` is used in messages.
/// \throws Error (bad_data) with the element and byte (or line, in ascii).
DiffusionSurfaces parse_surfaces(std::string_view bytes, const std::string& file);

DiffusionSurfaces read_surfaces(const std::filesystem::path& file);

}  // namespace pomona
