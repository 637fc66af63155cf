// Pieces as PLY: for MeshLab, CloudCompare and scripts (docs/reference/formats.md).
#pragma once

#include <string>

#include "render/export/styled_mesh.h"

namespace pomona {

/// The bytes of one binary little-endian PLY with every instance of the scene, where it lies: vertex float x y z,
/// float nx ny nz, uchar red green blue (sRGB), int part; face list uchar int vertex_indices, int piece (the
/// instance), int cut (the cut face, -1 on skin). Names are comments: "comment piece 3 tomato.2",
/// "comment part 1 flesh".
std::string write_solids(const Scene& scene, const ExportOptions& options = {});

}  // namespace pomona
