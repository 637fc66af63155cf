// A placed solid after projection, for the identity buffer and for the lines.
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

/// Calls visit for all instances in their order, with the index of the first and a group of projected instances. A
/// group takes a few tens of megabytes; all instances of a heap of ten thousand would take a gigabyte.
void visit_seen_solids(const Scene& scene, const Lens& lens, Threads threads,
                       const std::function<void(std::size_t first, std::span<const SeenSolid> seen)>& visit);

}  // namespace pomona
