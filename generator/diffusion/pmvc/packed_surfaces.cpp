#include "generator/diffusion/pmvc/packed_surfaces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "generator/diffusion/used_parts.h"

namespace pomona {

namespace {

std::vector<glm::vec4> with_weight(const std::vector<Color>& colors) {
  std::vector<glm::vec4> weighted;
  weighted.reserve(colors.size());
  for (const Color& color : colors) weighted.emplace_back(color, 1.0f);
  return weighted;
}

}  // namespace

glm::vec3 PackedSurfaces::normalized(const glm::vec3& point) const {
  return glm::vec3((glm::dvec3(point) - middle) * scale);
}

PackedSurfaces pack(const DiffusionSurfaces& surfaces, const SurfaceTree& tree) {
  PackedSurfaces packed;
  const Box<double>& all = tree.levels.back().front();
  packed.middle = 0.5 * (all.low + all.high);
  int exponent = 0;
  std::frexp(tree.size, &exponent);
  packed.scale = std::ldexp(1.0, 1 - exponent);

  packed.front_color = with_weight(surfaces.front_color);
  packed.back_color = with_weight(surfaces.back_color);
  for (const glm::uvec3& t : surfaces.triangle) {
    packed.triangle.push_back({static_cast<int>(t.x), static_cast<int>(t.y), static_cast<int>(t.z)});
  }
  UsedParts parts = used_parts(surfaces);
  packed.used_parts = std::move(parts.part);
  packed.front_part = std::move(parts.front);
  packed.back_part = std::move(parts.back);

  // Fills up the last group with single points, which cover nothing.
  constexpr auto size = static_cast<std::size_t>(TriangleGroup::size);
  packed.groups.resize((tree.order.size() + size - 1) / size);
  for (std::size_t i = 0; i < packed.groups.size() * size; ++i) {
    TriangleGroup& group = packed.groups[i / size];
    const std::uint32_t triangle = tree.order[std::min(i, tree.order.size() - 1)];
    group.triangle[i % size] = static_cast<std::int32_t>(triangle);
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = surfaces.triangle[triangle][i < tree.order.size() ? k : 0];
      const glm::vec3 corner = packed.normalized(surfaces.position[vertex]);
      for (int axis = 0; axis < 3; ++axis) group.corner[3 * k + axis][i % size] = corner[axis];
    }
  }
  return packed;
}

}  // namespace pomona
