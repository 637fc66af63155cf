#include "generator/surface/diffusion_surfaces.h"

#include <algorithm>
#include <array>

#include "generator/mesh/triangle_weights.h"
#include "generator/surface/merged_names.h"

namespace pomona {

bool DiffusionSurfaces::is_hidden(std::size_t triangle_index, SideOf side) const {
  const std::vector<std::uint8_t>& hidden = side == SideOf::front ? front_hidden : back_hidden;
  const glm::uvec3& t = triangle[triangle_index];
  return hidden[t.x] != 0 && hidden[t.y] != 0 && hidden[t.z] != 0;
}

bool DiffusionSurfaces::is_boundary(std::size_t triangle_index) const {
  return is_hidden(triangle_index, SideOf::front) != is_hidden(triangle_index, SideOf::back);
}

namespace {

template <typename T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

DiffusionSurfaces joined(const DiffusionSurfaces& first, const DiffusionSurfaces& second) {
  DiffusionSurfaces all = first;
  append(all.position, second.position);
  append(all.front_color, second.front_color);
  append(all.back_color, second.back_color);
  append(all.blur, second.blur);
  append(all.front_hidden, second.front_hidden);
  append(all.back_hidden, second.back_hidden);

  const auto first_vertex = static_cast<std::uint32_t>(first.vertex_count());
  for (const glm::uvec3& t : second.triangle) all.triangle.push_back(t + glm::uvec3(first_vertex));
  const auto first_surface = static_cast<std::int32_t>(first.surface_names.size());
  for (const std::int32_t s : second.surface) all.surface.push_back(s + first_surface);
  append(all.surface_names, second.surface_names);
  append(all.notes, second.notes);
  if (!first.instance.empty() || !second.instance.empty()) {
    all.instance.resize(first.triangle_count(), 0);
    append(all.instance, second.instance);
    all.instance.resize(all.triangle_count(), 0);
  }

  const std::vector<std::int32_t> part = merge_names(all.part_names, second.part_names);
  for (const std::int32_t p : second.front_part) all.front_part.push_back(part[static_cast<std::size_t>(p)]);
  for (const std::int32_t p : second.back_part) all.back_part.push_back(part[static_cast<std::size_t>(p)]);
  return all;
}

std::uint32_t add_vertex(DiffusionSurfaces& surfaces, const DiffusionSurfaces& from, std::uint32_t vertex) {
  // Both may be the same surfaces.
  const auto copy = [vertex](auto& to, const auto& values) {
    const auto value = values[vertex];
    to.push_back(value);
  };
  copy(surfaces.position, from.position);
  copy(surfaces.front_color, from.front_color);
  copy(surfaces.back_color, from.back_color);
  copy(surfaces.blur, from.blur);
  copy(surfaces.front_hidden, from.front_hidden);
  copy(surfaces.back_hidden, from.back_hidden);
  return static_cast<std::uint32_t>(surfaces.vertex_count() - 1);
}

std::uint32_t doubled_vertex(DiffusionSurfaces& surfaces, std::uint32_t vertex) {
  return add_vertex(surfaces, surfaces, vertex);
}

std::uint32_t add_vertex_within(DiffusionSurfaces& surfaces, const DiffusionSurfaces& from, const glm::uvec3& triangle,
                                const glm::dvec3& place) {
  const auto corner = [&](int k) { return glm::dvec3(from.position[triangle[k]]); };
  const std::array<double, 3> weight = weights_in({corner(0), corner(1), corner(2)}, place);
  Color front(0), back(0);
  float blur = 0;
  for (int k = 0; k < 3; ++k) {
    const auto w = static_cast<float>(weight[static_cast<std::size_t>(k)]);
    front += w * from.front_color[triangle[k]];
    back += w * from.back_color[triangle[k]];
    blur += w * from.blur[triangle[k]];
  }
  surfaces.position.emplace_back(place);
  surfaces.front_color.push_back(front);
  surfaces.back_color.push_back(back);
  surfaces.blur.push_back(blur);
  surfaces.front_hidden.push_back(0);
  surfaces.back_hidden.push_back(0);
  return static_cast<std::uint32_t>(surfaces.vertex_count() - 1);
}

Box<double> bounds_of(const DiffusionSurfaces& surfaces) {
  if (surfaces.triangle.empty()) return {glm::dvec3(0), glm::dvec3(0)};
  Box<double> bounds;
  for (const glm::uvec3& t : surfaces.triangle) {
    for (int k = 0; k < 3; ++k) bounds.add(glm::dvec3(surfaces.position[t[k]]));
  }
  return bounds;
}

}  // namespace pomona
