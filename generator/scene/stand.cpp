#include "generator/scene/stand.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "generator/base/reproducible.h"
#include "generator/scene/settle/drop.h"
#include "generator/scene/table_pose.h"

namespace pomona {

namespace {

/// Whether the scene is one whole fruit that is long, or would balance on its root.
void lay_down(Scene& scene) {
  if (scene.instances.size() != 1 || scene.instances[0].pose.rotation != glm::dquat(1, 0, 0, 0)) return;
  const Solid& solid = scene.solids[static_cast<std::size_t>(scene.instances[0].solid)];
  const auto is_cut = [](std::int32_t face) { return face >= 0; };
  if (std::any_of(solid.mesh.cut_face.begin(), solid.mesh.cut_face.end(), is_cut)) return;
  const TablePose pose = table_pose(solid);
  if (!pose.slender) return;

  // The diagonal as seen from straight in front.
  const glm::dvec3 back = scene.view.eye - scene.view.target;
  scene.instances[0].pose.rotation = turn_about({0, 1, 0}, reproducible::atan2(back.x, back.z)) * pose.rotation;
  scene.view = fitted_view(scene, scene.view.eye - scene.view.target);
}

}  // namespace

Scene standing(Scene scene) {
  lay_down(scene);
  double lowest = std::numeric_limits<double>::infinity();
  for (const Instance& instance : scene.instances)
    for (const glm::vec3& p : scene.solids[static_cast<std::size_t>(instance.solid)].mesh.position)
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
