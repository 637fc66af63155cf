#include "generator/scene/explode.h"

#include "generator/piece/piece_facts.h"

namespace pomona {

Scene exploded(Scene scene, double factor) {
  glm::dvec3 middle(0);
  double mass = 0;
  std::vector<glm::dvec3> center;
  for (const Instance& instance : scene.instances) {
    const PieceFacts facts = facts_of(scene.solids[static_cast<std::size_t>(instance.solid)]);
    center.push_back(instance.pose.rotation * facts.center + instance.pose.translation);
    middle += facts.volume * center.back();
    mass += facts.volume;
  }
  if (!(mass > 0)) return scene;
  middle /= mass;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    scene.instances[i].pose.translation += (factor - 1) * (center[i] - middle);
  }
  scene.view = fitted_view(scene, scene.view.eye - scene.view.target);
  return scene;
}

}  // namespace pomona
