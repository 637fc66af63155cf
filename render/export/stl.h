// Solids as STL: for printing and for programs that know nothing else (docs/reference/formats.md).
#pragma once

#include <string>

#include "generator/scene/scene.h"

namespace pomona {

/// The bytes of one binary STL with every instance of the scene, where it lies, in millimetres, which is what
/// programs take an STL's numbers for. No colours, no parts: the format has none. Triangles without area are left out.
std::string write_stl(const Scene& scene);

}  // namespace pomona
