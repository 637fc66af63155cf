// A placed solid as a lens sees it: what the identity buffer and the lines are both made from.
#pragma once

#include <vector>

#include "generator/scene/scene.h"
#include "render/strokes/lens.h"

namespace pomona {

struct SeenSolid {
  std::vector<glm::dvec3> vertex;  ///< as Lens::seen(); distance 0 where it cannot be seen
  std::vector<float> facing;       ///< above or at 0: the vertex' normal is turned to the eye
  glm::dmat3 turn{1};
  glm::dvec3 at{0};

  glm::dvec3 in_scene(const glm::vec3& own) const { return turn * glm::dvec3(own) + at; }
};

SeenSolid seen_solid(const Solid& solid, const Pose& pose, const Lens& lens);

}  // namespace pomona
