#include "render/gl/scene_camera.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace pomona {

TableShade table_shade_of(const Scene& scene, const SceneBall& ball) {
  TableShade shade;
  if (scene.ground) shade.reach = sky_reach(scene);
  if (shade.reach == 0) return shade;
  // The map's depth runs from a little under the table up to its reach.
  shade.side = 2.04f * ball.radius;
  const float half = 0.5f * shade.side, under = 0.02f * shade.reach;
  const glm::vec3 eye(ball.center.x, -under, ball.center.z);
  const glm::mat4 view = glm::lookAt(eye, eye + glm::vec3(0, 1, 0), glm::vec3(0, 0, 1));
  shade.to_clip = glm::ortho(-half, half, -half, half, 0.0f, shade.reach + under) * view;
  return shade;
}

SceneCamera camera_of(const Scene& scene, const SceneBall& ball, double aspect) {
  const glm::vec3 eye = scene.view.eye;
  const glm::vec3 target = scene.view.target;
  const glm::vec3 forward = glm::normalize(target - eye);
  const glm::vec3 up = std::fabs(forward.y) > 0.999f ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);

  SceneCamera camera;
  camera.view = glm::lookAt(eye, target, up);
  const float away = glm::dot(ball.center - eye, forward);
  camera.near = std::max(away - 1.2f * ball.radius, 0.01f * (std::fabs(away) + ball.radius));
  camera.far = std::max(away, 0.0f) + 6.0f * ball.radius;
  camera.tangent.y = static_cast<float>(std::tan(0.5 * scene.view.vertical_field));
  camera.tangent.x = static_cast<float>(camera.tangent.y * aspect);
  const glm::vec2 half = camera.tangent * camera.near;
  camera.projection = glm::frustum(-half.x, half.x, -half.y, half.y, camera.near, camera.far);
  return camera;
}

SceneLight light_of(const SceneCamera& camera, const SceneBall& ball, const LightStyle& style) {
  const glm::mat3 to_scene = glm::transpose(glm::mat3(camera.view));
  const double level = std::cos(style.elevation);
  glm::vec3 side = to_scene * glm::vec3(level * std::sin(style.azimuth), 0, level * std::cos(style.azimuth));
  side.y = 0;
  SceneLight light;
  light.to_light = glm::normalize(side + glm::vec3(0, std::sin(style.elevation), 0));

  // The box must contain all that casts shadows; what only receives them may lie behind it.
  const float r = 1.02f * ball.radius;
  const glm::vec3 up = std::fabs(light.to_light.y) > 0.99f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  const glm::mat4 view = glm::lookAt(ball.center + 2.0f * r * light.to_light, ball.center, up);
  light.to_clip = glm::ortho(-r, r, -r, r, 0.5f * r, 5.0f * r) * view;
  light.box = {2 * r, 4.5f * r};
  return light;
}

}  // namespace pomona
