// Wavefront OBJ: points and polygons as text.
#pragma once

#include <string>
#include <string_view>

#include "generator/surface/file/plain_mesh.h"

namespace pomona {

/// Reads v (with the three sRGB channels that some tools add), f, o and g; everything else is ignored. Polygons become
/// fans. `object` is the name of an object (o) or group (g); empty = all.
/// \throws Error (bad_data) with line and column.
PlainMesh parse_obj(std::string_view text, const std::string& file, const std::string& object);

}  // namespace pomona
