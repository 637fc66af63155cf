// A placed solid as a lens sees it: what the identity buffer and the lines are both made from.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "generator/base/parallel.h"
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

/// All instances in their order, as many at a time as a few tens of megabytes hold: those of a heap of ten thousand
/// would take a gigabyte together. Calls visit with the index of the first and those that were seen with it.
void visit_seen_solids(const Scene& scene, const Lens& lens, Threads threads,
                       const std::function<void(std::size_t first, std::span<const SeenSolid> seen)>& visit);

}  // namespace pomona
