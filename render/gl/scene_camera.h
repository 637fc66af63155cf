// The camera and the light of a scene, as matrices.
#pragma once

#include <glm/mat4x4.hpp>

#include "generator/scene/placed_boxes.h"
#include "generator/scene/scene.h"
#include "render/style/style.h"

namespace pomona {

struct SceneCamera {
  glm::mat4 view{1};        ///< scene to camera; it looks along -Z
  glm::mat4 projection{1};  ///< camera to clip space
  glm::vec2 tangent{1};     ///< tangents of half the field of view
  float near = 0, far = 1;  ///< metres
};

SceneCamera camera_of(const Scene& scene, const SceneBall& ball, double aspect);

struct SceneLight {
  glm::vec3 to_light{0, 1, 0};  ///< unit, scene
  glm::mat4 to_clip{1};         ///< scene to the shadow map's clip space
  glm::vec2 box{1};             ///< side and depth of that box, metres
};

SceneLight light_of(const SceneCamera& camera, const SceneBall& ball, const LightStyle& style);

/// The occlusion of the table by the pieces on it, from a view from below.
struct TableShade {
  glm::mat4 to_clip{1};  ///< scene to clip space; depth is height over the table, up to the reach
  float reach = 0;       ///< metres, sky_reach(); 0 without a table
  float side = 1;        ///< side of the map, metres
};

TableShade table_shade_of(const Scene& scene, const SceneBall& ball);

}  // namespace pomona
