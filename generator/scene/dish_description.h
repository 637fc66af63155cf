// The description of a dish in a scene file: a turned dish or a mesh. Pieces lie in it or on it, or it only stands
// there (docs/reference/formats.md).
#pragma once

#include <optional>
#include <string>

#include <glm/vec3.hpp>

#include "generator/base/curve.h"
#include "generator/base/error.h"
#include "generator/scene/mesh_solid.h"
#include "generator/template/ramp.h"

namespace pomona {

/// A dish as a solid of revolution. Its profile, metres, runs from the axis at the bottom along the outside, over the
/// rim and down the inside to the axis. It stands on y = 0.
struct BowlDescription {
  Curve profile;
  Ramp<Color> color = Ramp<Color>::constant(Color(0.8f));  ///< along the profile
  int around = 96, along = 96;                             ///< vertices
};

/// One of [[dishes]].
struct DishDescription {
  std::string name;                       ///< unique in the scene
  SourcePlace place;                      ///< place of its name in the file
  std::optional<BowlDescription> turned;  ///< else a mesh
  std::string mesh;                       ///< path from the scene's folder
  SourcePlace mesh_place;
  MeshSolidOptions as_solid{};
  glm::dvec3 at{0};     ///< metres
  double turn = 0;      ///< radians about the vertical
  std::string part_of;  ///< name of the dish in or on which this one stands; for pieces, both are one dish
};

}  // namespace pomona
