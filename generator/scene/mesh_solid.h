// A mesh from a modelling tool as a solid, for a scene's dishes.
#pragma once

#include <optional>
#include <string>

#include <glm/vec3.hpp>

#include "generator/base/color.h"
#include "generator/piece/solid.h"
#include "generator/surface/file/plain_mesh.h"

namespace pomona {

struct MeshSolidOptions {
  double unit = 1;             ///< metres of one unit of the file
  bool z_up = false;           ///< the file's Z is up, its Y to the back
  std::optional<Color> color;  ///< linear; else the file's own, else light grey
  MaterialSketch material{};
};

/// Its lowest point is moved to y = 0. Edges at which the surface turns by more than 40 degrees stay sharp.
Solid mesh_solid(const PlainMesh& mesh, const std::string& name, const MeshSolidOptions& options = {});

}  // namespace pomona
