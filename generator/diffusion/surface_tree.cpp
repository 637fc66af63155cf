#include "generator/diffusion/surface_tree.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/diffusion/morton.h"

namespace pomona {

namespace {

bool is_finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void require_finite(const DiffusionSurfaces& surfaces) {
  for (std::size_t v = 0; v < surfaces.vertex_count(); ++v) {
    if (is_finite(surfaces.position[v]) && is_finite(surfaces.front_color[v]) && is_finite(surfaces.back_color[v])) {
      continue;
    }
    throw Error(ExitStatus::bad_data,
                "surfaces: vertex " + std::to_string(v) + " has a coordinate or a colour that is not finite",
                "remove the vertex or give it finite values");
  }
}

/// Neither a point nor a line, as far as doubles can tell.
bool has_area(const DiffusionSurfaces& surfaces, std::uint32_t triangle) {
  const auto [a, b, c] = corners(surfaces, triangle);
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  return normal.x != 0 || normal.y != 0 || normal.z != 0;
}

void grow(Box& box, const Box& other) {
  box.low = glm::min(box.low, other.low);
  box.high = glm::max(box.high, other.high);
}

Box box_of(const DiffusionSurfaces& surfaces, std::uint32_t triangle) {
  const auto [a, b, c] = corners(surfaces, triangle);
  return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
}

/// One box for every `step` of `count` things.
template <typename BoxOf>
std::vector<Box> boxes_over(std::size_t count, std::size_t step, const BoxOf& box_of_thing) {
  std::vector<Box> boxes((count + step - 1) / step);
  for (std::size_t i = 0; i < count; ++i) {
    Box& box = boxes[i / step];
    const Box thing = box_of_thing(i);
    if (i % step == 0) box = thing;
    grow(box, thing);
  }
  return boxes;
}

std::vector<std::uint32_t> morton_order(const DiffusionSurfaces& surfaces) {
  std::vector<std::uint32_t> solid;
  for (std::uint32_t t = 0; t < surfaces.triangle_count(); ++t) {
    if (has_area(surfaces, t)) solid.push_back(t);
  }
  if (solid.empty()) throw Error(ExitStatus::bad_data, "surfaces: there is no triangle with any area to diffuse from");

  // Sort by the code of the middle, then by index.
  Box all = box_of(surfaces, solid.front());
  for (const std::uint32_t t : solid) grow(all, box_of(surfaces, t));
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed;
  keyed.reserve(solid.size());
  for (const std::uint32_t t : solid) {
    const Box box = box_of(surfaces, t);
    keyed.emplace_back(morton_code(0.5 * (box.low + box.high), all.low, all.high), t);
  }
  std::sort(keyed.begin(), keyed.end());
  std::transform(keyed.begin(), keyed.end(), solid.begin(), [](const auto& key) { return key.second; });
  return solid;
}

}  // namespace

std::array<glm::dvec3, 3> corners(const DiffusionSurfaces& surfaces, std::uint32_t triangle) {
  const glm::uvec3& t = surfaces.triangle[triangle];
  return {glm::dvec3(surfaces.position[t.x]), glm::dvec3(surfaces.position[t.y]), glm::dvec3(surfaces.position[t.z])};
}

NearestChildren nearest_children(const SurfaceTree& tree, std::size_t level, std::size_t index, const glm::dvec3& point,
                                 double most) {
  const std::vector<Box>& boxes = tree.levels[level - 1];
  const std::size_t first = index * SurfaceTree::branching;
  const std::size_t end = std::min(first + SurfaceTree::branching, boxes.size());
  NearestChildren sorted;
  for (std::size_t i = first; i < end; ++i) {
    const double distance = squared_distance(boxes[i], point);
    if (distance > most) continue;
    std::size_t place = sorted.count++;
    for (; place > 0 && sorted.child[place - 1].first > distance; --place) {
      sorted.child[place] = sorted.child[place - 1];
    }
    sorted.child[place] = {distance, i};
  }
  return sorted;
}

std::pair<std::size_t, std::size_t> leaf(const SurfaceTree& tree, std::size_t index) {
  const std::size_t first = index * SurfaceTree::leaf_size;
  return {first, std::min(first + SurfaceTree::leaf_size, tree.order.size())};
}

SurfaceTree make_surface_tree(const DiffusionSurfaces& surfaces) {
  require_finite(surfaces);
  SurfaceTree tree;
  tree.order = morton_order(surfaces);
  tree.levels.push_back(boxes_over(tree.order.size(), SurfaceTree::leaf_size,
                                   [&](std::size_t i) { return box_of(surfaces, tree.order[i]); }));
  while (tree.levels.back().size() > 1) {
    const std::vector<Box>& below = tree.levels.back();
    tree.levels.push_back(boxes_over(below.size(), SurfaceTree::branching, [&](std::size_t i) { return below[i]; }));
  }
  const Box& all = tree.levels.back().front();
  tree.size = glm::length(all.high - all.low);
  return tree;
}

}  // namespace pomona
