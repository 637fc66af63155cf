#include "generator/surface/stray_surfaces.h"

#include <algorithm>

#include "generator/surface/body_walls.h"

namespace pomona {

namespace {

constexpr std::size_t max_asked = 500;  // limit of tested triangles of a surface

/// The inner triangles of each surface.
std::vector<std::vector<std::size_t>> inner_triangles(const DiffusionSurfaces& surfaces) {
  std::vector<std::vector<std::size_t>> inner(surfaces.surface_names.size());
  for (std::size_t t = 0; t < surfaces.triangle_count(); ++t)
    if (!surfaces.is_boundary(t)) inner[static_cast<std::size_t>(surfaces.surface[t])].push_back(t);
  return inner;
}

glm::dvec3 middle_of(const DiffusionSurfaces& surfaces, std::size_t t) {
  const glm::uvec3& v = surfaces.triangle[t];
  return (glm::dvec3(surfaces.position[v.x]) + glm::dvec3(surfaces.position[v.y]) +
          glm::dvec3(surfaces.position[v.z])) /
         3.0;
}

}  // namespace

std::vector<std::string> stray_warnings(const DiffusionSurfaces& surfaces, const Bodies& bodies) {
  if (std::none_of(bodies.bodies.begin(), bodies.bodies.end(), [](const Bodies::Body& body) { return body.closed; }))
    return {};
  const Enclosures walls = body_walls(surfaces, bodies);
  const auto is_outside = [&](const glm::dvec3& point) {
    int winding = 0;
    for (const auto& [body, times] : walls.around(point)) winding += times;
    return winding <= 0;
  };

  std::vector<std::string> warnings;
  const std::vector<std::vector<std::size_t>> inner = inner_triangles(surfaces);
  for (std::size_t s = 0; s < inner.size(); ++s) {
    const std::size_t step = inner[s].size() / max_asked + 1;
    std::size_t asked = 0, outside = 0;
    for (std::size_t i = 0; i < inner[s].size(); i += step, ++asked)
      if (is_outside(middle_of(surfaces, inner[s][i]))) ++outside;
    if (asked == 0 || 10 * outside < asked) continue;
    warnings.push_back("surface \"" + surfaces.surface_names[s] + "\": " + std::to_string(100 * outside / asked) +
                       " % of it lies outside the fruit");
  }
  return warnings;
}

}  // namespace pomona
