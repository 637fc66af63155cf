#include "tests/diffusion/fields.h"

#include <algorithm>
#include <cmath>

#include "generator/base/random.h"
#include "tests/shapes/shapes.h"

namespace pomona::fields {

DiffusionSurfaces painted_with(DiffusionSurfaces surfaces, const Field& field) {
  for (std::size_t v = 0; v < surfaces.vertex_count(); ++v) {
    surfaces.front_color[v] = surfaces.back_color[v] = Color(field(glm::dvec3(surfaces.position[v])));
  }
  return surfaces;
}

glm::dvec3 dyadic_linear(const glm::dvec3& p) {
  return {0.5 + p.x / 4 + p.y / 8, 0.5 - p.y / 4 + p.z / 8, 0.5 + p.x / 8 - p.y / 8 + p.z / 8};
}

DiffusionSurfaces linear_scene() {
  const DiffusionSurfaces room = shapes::box({-1, -1, -1}, {1, 1, 1}, 4);
  const DiffusionSurfaces block = shapes::box({0.125, -0.5, 0.25}, {0.5, 0.25, 0.75}, 1);
  const DiffusionSurfaces sheet = shapes::moved(shapes::open_sheet(0.5, -0.625, 2), {-0.25, 0, -0.25});
  return painted_with(joined(joined(room, block), sheet), dyadic_linear);
}

std::vector<glm::vec3> points_in_linear_scene() {
  const RandomStream random({}, "tests/points in linear scene");
  std::vector<glm::vec3> points;
  for (std::uint64_t n = 0; points.size() < 60; n += 3) {
    const glm::dvec3 p(2 * random.uniform(n) - 1, 2 * random.uniform(n + 1) - 1, 2 * random.uniform(n + 2) - 1);
    const bool is_in_block = p.x > 0.12 && p.x < 0.51 && p.y > -0.51 && p.y < 0.26 && p.z > 0.24 && p.z < 0.76;
    if (!is_in_block) points.emplace_back(0.999 * p);
  }
  return points;
}

Errors errors_of(const std::vector<Color>& colors, const std::vector<Color>& truth) {
  std::vector<double> worst;
  double squares = 0;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const glm::dvec3 error = 255.0 * (glm::dvec3(colors[i]) - glm::dvec3(truth[i]));
    squares += error.x * error.x + error.y * error.y + error.z * error.z;
    worst.push_back(std::max({std::fabs(error.x), std::fabs(error.y), std::fabs(error.z)}));
  }
  std::sort(worst.begin(), worst.end());
  return {std::sqrt(squares / (3.0 * static_cast<double>(worst.size()))), worst[worst.size() * 95 / 100], worst.back()};
}

}  // namespace pomona::fields
