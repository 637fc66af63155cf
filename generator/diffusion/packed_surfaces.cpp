#include "generator/diffusion/packed_surfaces.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "generator/base/error.h"

namespace pomona {

namespace {

constexpr std::size_t most_parts = 1024;  // weights are kept per point and part

std::vector<std::int32_t> parts_in_use(const DiffusionSurfaces& surfaces) {
  std::vector<std::int32_t> used = surfaces.front_part;
  used.insert(used.end(), surfaces.back_part.begin(), surfaces.back_part.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  if (used.size() > most_parts) {
    throw Error(ExitStatus::bad_data,
                "surfaces: " + std::to_string(used.size()) + " parts are used, more than " + std::to_string(most_parts),
                "give sides that belong together the same part");
  }
  return used;
}

std::vector<std::uint16_t> places_in(const std::vector<std::int32_t>& used, const std::vector<std::int32_t>& parts) {
  std::vector<std::uint16_t> places;
  places.reserve(parts.size());
  for (const std::int32_t part : parts) {
    places.push_back(static_cast<std::uint16_t>(std::lower_bound(used.begin(), used.end(), part) - used.begin()));
  }
  return places;
}

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
  const Box& all = tree.levels.back().front();
  packed.middle = 0.5 * (all.low + all.high);
  int exponent = 0;
  std::frexp(tree.size, &exponent);
  packed.scale = std::ldexp(1.0, 1 - exponent);

  packed.front_color = with_weight(surfaces.front_color);
  packed.back_color = with_weight(surfaces.back_color);
  for (const glm::uvec3& t : surfaces.triangle) {
    packed.triangle.push_back({static_cast<int>(t.x), static_cast<int>(t.y), static_cast<int>(t.z)});
  }
  packed.used_parts = parts_in_use(surfaces);
  packed.front_part = places_in(packed.used_parts, surfaces.front_part);
  packed.back_part = places_in(packed.used_parts, surfaces.back_part);

  // Fill up the last group with points, which cover nothing.
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
