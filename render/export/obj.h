// Solids as Wavefront OBJ, for modelling tools (docs/reference/formats.md).
#pragma once

#include <span>
#include <string>

#include "render/export/styled_mesh.h"

namespace pomona {

/// The text of an OBJ with every instance of the scene, where it lies, in metres: `o` with its name, `v` with a
/// colour (sRGB, 0 to 1) after the place, `vn`, and `f` with both. Numbers are written so that they read back as the
/// same bits.
std::string write_obj(const Scene& scene, const ExportOptions& options = {});

/// The text of an OBJ of some triangles with normals, or none, about a pivot, which becomes the origin: for programs
/// that take a mesh from one file and its colour from another.
std::string write_obj(std::span<const glm::vec3> position, std::span<const glm::vec3> normal,
                      std::span<const glm::uvec3> triangle, const glm::vec3& pivot);

}  // namespace pomona
