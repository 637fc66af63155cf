// Models for MuJoCo (.xml, MJCF).
#pragma once

#include <string>

#include "generator/scene/scene.h"
#include "render/export/styled_mesh.h"

namespace pomona {

/// The text of a model: a body for each instance, pieces free to move and dishes fast, the ground, the scene's camera,
/// and all meshes within. Metres, kilograms, +Z up. A body's origin is its centre of mass, its axes are those of the
/// fruit. Same scene and options, same bytes.
std::string write_mjcf(const Scene& scene, const ExportOptions& options = {});

}  // namespace pomona
