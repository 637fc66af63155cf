#include "render/thumbnail/ground_shadow.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "render/picture/light_direction.h"
#include "render/thumbnail/covered_samples.h"

namespace pomona {

namespace {

/// What lies in the shadow of something, per pixel 0 or 1: everything thrown along `towards_light` on the ground.
std::vector<float> thrown(const Scene& scene, std::span<const StyledMesh> meshes, const Projection& projection,
                          const glm::dvec3& towards_light, int side) {
  std::vector<float> mask(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 0.0f);
  for (const Instance& instance : scene.instances) {
    const StyledMesh& mesh = meshes[static_cast<std::size_t>(instance.solid)];
    std::vector<ProjectedPoint> points;
    points.reserve(mesh.position.size());
    for (const glm::vec3& position : mesh.position) {
      const glm::dvec3 p = instance.pose.rotation * glm::dvec3(position) + instance.pose.translation;
      points.push_back(projection(p - towards_light * (p.y / towards_light.y)));
    }
    for (const glm::uvec3& t : mesh.triangle) {
      for_covered_samples({points[t.x], points[t.y], points[t.z]}, side, [&](int x, int y, const glm::dvec3&) {
        mask[static_cast<std::size_t>(y) * side + x] = 1.0f;
      });
    }
  }
  return mask;
}

/// The mean over 2 radius + 1 values of each row; beyond the picture there is none. Rows become columns.
std::vector<float> averaged_and_turned(const std::vector<float>& values, int side, int radius) {
  std::vector<float> result(values.size());
  const float share = 1.0f / static_cast<float>(2 * radius + 1);
  for (int y = 0; y < side; ++y) {
    const float* row = &values[static_cast<std::size_t>(y) * side];
    float sum = 0;
    for (int x = 0; x < std::min(radius, side); ++x) sum += row[x];
    for (int x = 0; x < side; ++x) {
      if (x + radius < side) sum += row[x + radius];
      if (x - radius - 1 >= 0) sum -= row[x - radius - 1];
      result[static_cast<std::size_t>(x) * side + y] = std::max(0.0f, sum * share);
    }
  }
  return result;
}

/// Three means one after another are nearly a Gaussian.
std::vector<float> softened(std::vector<float> values, int side, int radius) {
  for (int pass = 0; pass < 6; ++pass) values = averaged_and_turned(values, side, radius);
  return values;
}

}  // namespace

std::vector<float> ground_shadow(const Scene& scene, std::span<const StyledMesh> meshes, const Style& style, int side) {
  const Projection projection(scene.view, side);
  const auto radius = [side](double share) { return std::max(1, static_cast<int>(std::lround(share * side))); };

  // From the light: long, and softer the softer the light is.
  const glm::dvec3 to_light = light_direction(projection.frame(), style.light.azimuth, style.light.elevation);
  std::vector<float> shadow =
      softened(thrown(scene, meshes, projection, to_light, side), side, radius(0.008 + 0.03 * style.light.softness));

  // From above: close to the pieces.
  const std::vector<float> contact = softened(thrown(scene, meshes, projection, {0, 1, 0}, side), side, radius(0.012));
  const auto strength = static_cast<float>(style.shadow.strength);
  for (std::size_t i = 0; i < shadow.size(); ++i) {
    const float dark = 1 - (1 - 0.42f * shadow[i]) * (1 - 0.30f * contact[i]);
    shadow[i] = std::clamp(strength * dark, 0.0f, 1.0f);
  }
  return shadow;
}

}  // namespace pomona
