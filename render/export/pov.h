// POV-Ray 3.7 scenes (docs/reference/formats.md).
#pragma once

#include <string>
#include <vector>

#include "render/export/named_file.h"
#include "render/export/pov_ink.h"
#include "render/export/styled_mesh.h"

namespace pomona {

/// `stem`.pov and the include it names, `stem`_meshes.inc, to lie beside it. Every solid is declared once, as a
/// mesh2 whose vertices have colours, and placed by exact matrices; camera, lights and ground are in the .pov, for
/// people to edit. Renders with `povray stem.pov`; nothing in it is random. Strokes, where there are any, are declared
/// as one object, Ink, that is right for the scene's camera alone.
std::vector<NamedFile> write_pov(const Scene& scene, const std::string& stem, const ExportOptions& options = {},
                                 const SceneInk& ink = {});

}  // namespace pomona
