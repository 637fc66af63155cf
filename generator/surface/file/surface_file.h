// Surfaces as PLY, for exchange with modelling tools (docs/reference/formats.md).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "generator/surface/diffusion_surfaces.h"
#include "generator/surface/file/placing.h"
#include "generator/surface/file/plain_mesh.h"

namespace pomona {

/// The bytes of a binary little-endian PLY that holds everything in `surfaces`; reading it back gives equal
/// values.
std::string write_surfaces(const DiffusionSurfaces& surfaces);

/// Reads PLY tolerantly: ascii and both byte orders, polygons and strips, extra and missing properties, colours at
/// faces. Where no hidden flag is there at all, the outermost closed shell counts as skin. Counts are checked against
/// the file's size before anything is allocated. Points are placed before they are rounded to floats. `file` is used
/// in messages.
/// \throws Error (bad_data) with the element and byte (or line, in ascii); for what lies too far away to be rounded.
DiffusionSurfaces parse_surfaces(std::string_view bytes, const std::string& file, const Placing& placing = {});

/// The same file, or one surface of it, as a plain mesh with the front's colours; without any where the file has none.
/// \throws Error (bad_data) also where there is no such surface.
PlainMesh parse_plain_surfaces(std::string_view bytes, const std::string& file, const std::string& object);

DiffusionSurfaces read_surfaces(const std::filesystem::path& file);

}  // namespace pomona
