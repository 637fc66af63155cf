// The header of a PLY file.
#pragma once

#include "generator/surface/file/ply.h"

namespace pomona {

/// \throws Error (bad_data) with line and column.
PlyHeader parse_ply_header(std::string_view bytes, const std::string& file);

/// The place of a byte in a text.
SourcePlace place_in_text(std::string_view bytes, std::size_t byte, const std::string& file);

}  // namespace pomona
