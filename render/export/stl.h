// Solids as STL, for 3D printing and for programs that read no other format (docs/reference/formats.md).
#pragma once

#include <string>

#include "generator/scene/scene.h"

namespace pomona {

/// The bytes of one binary STL with every instance of the scene at its pose, in millimetres, the usual unit of STL. The
/// format has no colours and no parts. Triangles of area 0 are omitted.
std::string write_stl(const Scene& scene);

}  // namespace pomona
