// USD in its text form (.usda): for Omniverse, Houdini, Maya, Blender (docs/formats.md).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "render/export/styled_mesh.h"

namespace pomona {

/// The bytes of a .usda: a class prim per solid, a reference to it per instance, the scene's camera. Metres, +Y up;
/// colours of vertices as displayColor, linear. Same scene and options, same bytes.
/// \param levels one entry per solid of the scene, or none: its coarser levels, finer before coarser, as variants LOD1,
/// LOD2, ... of the variant set LOD.
std::string write_usda(const Scene& scene, const ExportOptions& options = {},
                       std::span<const std::vector<Solid>> levels = {});

}  // namespace pomona
