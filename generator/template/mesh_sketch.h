// Surfaces of a template that come from a modelling tool instead of curves.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <glm/vec3.hpp>

#include "generator/template/side.h"

namespace pomona {

enum class MeshFormat { ply, obj, glb };

/// The bytes of a file, not yet parsed (surface/mesh_surfaces.h parses them). Variants share it.
struct MeshFile {
  std::string path;  ///< for messages
  MeshFormat format = MeshFormat::ply;
  std::string bytes;
};

/// The paint that the template gives a mesh. Ramps `along` run from the mesh's lowest vertex to its highest, or with
/// the distance from a point; ramps `around` with the angle about the vertical line through the middle of its box;
/// `turn` is about the fruit's axis.
struct MeshPaint {
  Side front;  ///< front = the side from which corners run counter-clockwise
  Side back;
  bool front_color_from_file = false;  ///< use the file's own vertex colours instead of front.color
  bool back_color_from_file = false;
  PaintedBlur blur;
  std::optional<glm::dvec3> ramps_from;  ///< if set, ramps `along` run with the distance from this point, metres
};

/// One [[mesh]]: a file, or one object of it. Without paint, the file has its own colours, as surface files (.ply) do.
struct MeshSketch {
  std::string name;
  std::shared_ptr<const MeshFile> file;
  std::string object;        ///< empty = all that the file holds
  double unit = 1;           ///< metres of one unit of the file
  bool z_up = false;         ///< the file's Z is up, its Y to the back
  std::optional<bool> flip;  ///< front and back of every triangle changed, or not; else shells turn as they must
  glm::dvec3 at{0};          ///< position of the file's origin, metres
  std::optional<MeshPaint> paint;
};

}  // namespace pomona
