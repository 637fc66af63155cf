#include "render/gl/scene_instances.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "generator/mesh/box.h"
#include "generator/scene/placed_boxes.h"

namespace pomona {

namespace {

/// Half the diagonal of the solid's box, metres.
std::vector<double> radii_of(const Scene& scene) {
  std::vector<double> radii;
  for (const Solid& solid : scene.solids) {
    const glm::vec3 size = box_around(solid.mesh.position).size();
    radii.push_back(solid.mesh.position.empty() ? 0.0 : 0.5 * static_cast<double>(glm::length(size)));
  }
  return radii;
}

}  // namespace

std::vector<InstanceTexels> instance_texels(const Scene& scene, const SceneCamera& camera, const Style& style,
                                            const glm::dvec2& samples) {
  const std::vector<double> radii = radii_of(scene);
  const double side = std::min(samples.x, samples.y);
  std::vector<InstanceTexels> texels;
  for (const Instance& instance : scene.instances) {
    const InkStyle& ink = scene.solids[instance.solid].look->ink;
    const double radius = radii[instance.solid];
    const glm::dvec3 center = instance.pose.translation;
    const double away =
        std::max(-(glm::dmat4(camera.view) * glm::dvec4(center, 1)).z, static_cast<double>(camera.near));
    const double seen = 2 * radius / away / camera.tangent.y * 0.5 * samples.y;  // samples
    const double fine = std::clamp(std::sqrt(seen / (0.7 * side)), 0.3, 1.0);
    const double width = side * fine * ink.width * style.outline_width;
    const double inner = side * fine * ink.width * style.inner_width;
    const glm::mat4 rows = glm::transpose(glm::inverse(matrix_of(instance.pose)));
    texels.push_back({glm::vec4(style.ink_color.value_or(ink.color), width),
                      glm::vec4(0.3 * radius + 1e-6, inner, instance.solid, scene.solids[instance.solid].opacity),
                      {rows[0], rows[1], rows[2]}});
  }
  return texels;
}

}  // namespace pomona
