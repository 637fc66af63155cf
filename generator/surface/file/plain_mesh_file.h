// Reads a plain mesh from a file of any format.
#pragma once

#include <filesystem>

#include "generator/surface/file/plain_mesh.h"

namespace pomona {

/// Reads .obj, .glb or .ply; of surfaces the front's colour. Removes vertices that no triangle uses.
/// \throws Error (bad_data) for another ending, more than 64 MiB, or with the place in the file, (input_missing) if it
/// cannot be read.
PlainMesh read_plain_mesh(const std::filesystem::path& file);

}  // namespace pomona
