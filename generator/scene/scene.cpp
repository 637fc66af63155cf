#include "generator/scene/scene.h"

#include <utility>

namespace pomona {

Scene gathered(std::vector<Solid> solids) {
  Scene scene;
  scene.solids = std::move(solids);
  for (std::size_t i = 0; i < scene.solids.size(); ++i)
    scene.instances.push_back({static_cast<int>(i), Pose{}, scene.solids[i].name});
  scene.view = fitted_view(scene, {0.5, 0.55, 1.0});
  return scene;
}

}  // namespace pomona
