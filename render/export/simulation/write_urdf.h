// Models for programs of robots (.urdf).
#pragma once

#include <string>
#include <vector>

#include "generator/scene/scene.h"
#include "render/export/named_file.h"
#include "render/export/styled_mesh.h"

namespace pomona {

struct UrdfFiles {
  std::string text;
  std::vector<NamedFile> meshes;  ///< .obj, which the text names by their place beside it
};

/// A link for each instance, with joints to the link "scene": floating of pieces, fixed of dishes. Metres, kilograms,
/// +Z up; a link's origin is its centre of mass. \param stem begins the names of all meshes:
/// "salad_tomato_piece_1_skin.obj".
UrdfFiles write_urdf(const Scene& scene, const std::string& stem, const ExportOptions& options = {});

}  // namespace pomona
