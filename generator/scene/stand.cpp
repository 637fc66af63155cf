#include "generator/scene/stand.h"

#include <algorithm>
#include <limits>

namespace pomona {

Scene standing(Scene scene) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Instance& instance : scene.instances)
    for (const glm::vec3& p : scene.solids[static_cast<std::size_t>(instance.solid)].position)
      lowest = std::min(lowest, (instance.pose.rotation * glm::dvec3(p) + instance.pose.translation).y);
  scene.ground = true;
  if (!(lowest < std::numeric_limits<double>::infinity())) return scene;
  const glm::dvec3 step(0, -lowest, 0);
  for (Instance& instance : scene.instances) instance.pose.translation += step;
  scene.view.eye += step;
  scene.view.target += step;
  return scene;
}

}  // namespace pomona
