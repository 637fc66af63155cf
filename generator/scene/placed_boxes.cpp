#include "generator/scene/placed_boxes.h"

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "generator/mesh/box.h"

namespace pomona {

glm::mat4 matrix_of(const Pose& pose) {
  glm::dmat4 matrix = glm::mat4_cast(pose.rotation);
  matrix[3] = glm::dvec4(pose.translation, 1);
  return glm::mat4(matrix);
}

namespace {

/// The placed bounding boxes of all instances with vertices.
std::vector<Box<float>> placed_boxes(const Scene& scene) {
  std::vector<Box<float>> own;
  for (const Solid& solid : scene.solids) own.push_back(box_around(solid.mesh.position));
  std::vector<Box<float>> placed;
  for (const Instance& instance : scene.instances) {
    const auto& [a, b] = own[static_cast<std::size_t>(instance.solid)];
    if (a.x > b.x) continue;
    const glm::mat4 place = matrix_of(instance.pose);
    Box<float>& box = placed.emplace_back();
    for (int corner = 0; corner < 8; ++corner) {
      const glm::vec4 at((corner & 1) != 0 ? b.x : a.x, (corner & 2) != 0 ? b.y : a.y, (corner & 4) != 0 ? b.z : a.z,
                         1);
      box.add(glm::vec3(place * at));
    }
  }
  return placed;
}

SceneBall ball_of(const std::vector<Box<float>>& boxes) {
  if (boxes.empty()) return {glm::vec3(0), 0.1f};
  Box<float> all;
  for (const Box<float>& box : boxes) all.add(box);
  return {all.center(), std::max(0.5f * glm::length(all.size()), 1e-4f)};
}

}  // namespace

SceneBall ball_around(const Scene& scene) { return ball_of(placed_boxes(scene)); }

float sky_reach(const Scene& scene) {
  const std::vector<Box<float>> boxes = placed_boxes(scene);
  if (boxes.empty()) return 0;
  // Thin parts, such as a cherry's stem, must not make the reach larger.
  float size = 0;
  for (const Box<float>& box : boxes)
    size += std::min(box.size().y, std::max(box.size().x, box.size().z)) / static_cast<float>(boxes.size());
  const float radius = ball_of(boxes).radius;
  return std::clamp(0.6f * size, 0.01f * radius, radius);
}

}  // namespace pomona
