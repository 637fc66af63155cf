#include "render/diffusion/ray_surfaces.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "generator/diffusion/used_parts.h"

namespace pomona {

namespace {

glm::uvec4 bits(const glm::vec3& corner, std::uint32_t vertex) {
  return {std::bit_cast<std::uint32_t>(corner.x), std::bit_cast<std::uint32_t>(corner.y),
          std::bit_cast<std::uint32_t>(corner.z), vertex};
}

std::vector<glm::vec3> normalized_positions(const DiffusionSurfaces& surfaces, const RayFrame& frame) {
  std::vector<glm::vec3> positions;
  positions.reserve(surfaces.vertex_count());
  for (const glm::vec3& position : surfaces.position) positions.push_back(frame.normalized(position));
  return positions;
}

/// The triangles with an area, in the order of the surfaces.
std::vector<std::uint32_t> ascending(const SurfaceTree& tree, std::size_t triangles) {
  std::vector<std::uint8_t> has_area(triangles);
  for (const std::uint32_t t : tree.order) has_area[t] = 1;
  std::vector<std::uint32_t> chosen;
  chosen.reserve(tree.order.size());
  for (std::uint32_t t = 0; t < triangles; ++t) {
    if (has_area[t] != 0) chosen.push_back(t);
  }
  return chosen;
}

}  // namespace

glm::vec3 RayFrame::normalized(const glm::vec3& point) const { return glm::vec3((glm::dvec3(point) - middle) * scale); }

RayFrame ray_frame(const DiffusionSurfaces& surfaces, const SurfaceTree& tree) {
  int exponent = 0;
  std::frexp(tree.size, &exponent);
  return {tree.levels.back().front().center(), std::ldexp(1.0, 1 - exponent), used_parts(surfaces).part};
}

RaySurfaces ray_surfaces(const DiffusionSurfaces& surfaces, const SurfaceTree& tree, const RayFrame& frame) {
  const std::vector<glm::vec3> positions = normalized_positions(surfaces, frame);
  RayTree rays = make_ray_tree(positions, surfaces.triangle, ascending(tree, surfaces.triangle_count()));
  RaySurfaces result;
  result.node = std::move(rays.node);

  // Put everything else into the order of the leaves.
  const UsedParts parts = used_parts(surfaces);
  result.triangle.reserve(rays.order.size());
  result.side.reserve(rays.order.size());
  result.color.reserve(2 * surfaces.vertex_count());
  for (const std::uint32_t t : rays.order) {
    const glm::uvec3& vertex = surfaces.triangle[t];
    result.triangle.push_back({bits(positions[vertex.x], vertex.x), bits(positions[vertex.y], vertex.y),
                               bits(positions[vertex.z], vertex.z)});
    result.side.emplace_back(t, parts.front[t] | std::uint32_t{parts.back[t]} << 16);
  }
  for (std::size_t v = 0; v < surfaces.vertex_count(); ++v) {
    result.color.emplace_back(surfaces.front_color[v], 1);
    result.color.emplace_back(surfaces.back_color[v], 1);
  }
  return result;
}

}  // namespace pomona
