// A scene: solids, each with any number of placed instances, and a view.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/piece/pose.h"
#include "generator/piece/solid.h"

namespace pomona {

struct Instance {
  int solid = 0;  ///< index into Scene::solids
  Pose pose;
  std::string name;  ///< unique within the scene
};

/// A perspective camera.
struct View {
  glm::dvec3 eye{0.3, 0.35, 0.5};
  glm::dvec3 target{0};
  double vertical_field = 0.5;  ///< radians
  bool fitted = false;          ///< by fitted_view(): a picture of another shape may fit it anew
};

struct Scene {
  std::vector<Solid> solids;
  std::vector<Instance> instances;
  View view;
  Color paper{0.93f, 0.90f, 0.83f};
  bool ground = false;  ///< a ground plane at y = 0 that takes shadows
};

/// A scene with every solid once, where it grew.
Scene gathered(std::vector<Solid> solids);

/// The nearest view that shows all of the scene, with a small margin: the scene touches the margin left and right, or
/// above and below. The perspective is taken into account exactly. \param direction from the target to the eye, any
/// length. \param aspect the picture's width over its height. \param light towards the light: then shadows on the
/// ground, and where it loses sky, are in the view, too.
View fitted_view(const Scene& scene, const glm::dvec3& direction, double aspect = 1.0,
                 const std::optional<glm::dvec3>& light = {});

}  // namespace pomona
