#include "generator/diffusion/surface_tree.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/morton.h"

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

Box<double> box_of(const DiffusionSurfaces& surfaces, std::uint32_t triangle) {
  const auto [a, b, c] = corners(surfaces, triangle);
  return box_around(a, b, c);
}

/// One box for every `step` of `count` things.
template <typename BoxOf>
std::vector<Box<double>> boxes_over(std::size_t count, std::size_t step, const BoxOf& box_of_thing) {
  std::vector<Box<double>> boxes((count + step - 1) / step);
  for (std::size_t i = 0; i < count; ++i) boxes[i / step].add(box_of_thing(i));
  return boxes;
}

/// The triangles with an area, along a Morton curve through the middles of their boxes.
std::vector<std::uint32_t> along_curve(const DiffusionSurfaces& surfaces) {
  std::vector<std::uint32_t> solid;
  std::vector<glm::dvec3> middles;
  solid.reserve(surfaces.triangle_count());
  middles.reserve(surfaces.triangle_count());
  for (std::uint32_t t = 0; t < surfaces.triangle_count(); ++t) {
    if (!has_area(surfaces, t)) continue;
    solid.push_back(t);
    middles.push_back(box_of(surfaces, t).center());
  }
  if (solid.empty()) throw Error(ExitStatus::bad_data, "surfaces: there is no triangle with any area to diffuse from");

  std::vector<std::uint32_t> order = morton_order(middles);
  for (std::uint32_t& entry : order) entry = solid[entry];
  return order;
}

}  // namespace

std::array<glm::dvec3, 3> corners(const DiffusionSurfaces& surfaces, std::uint32_t triangle) {
  const glm::uvec3& t = surfaces.triangle[triangle];
  return {glm::dvec3(surfaces.position[t.x]), glm::dvec3(surfaces.position[t.y]), glm::dvec3(surfaces.position[t.z])};
}

NearestChildren nearest_children(const SurfaceTree& tree, std::size_t level, std::size_t index, const glm::dvec3& point,
                                 double max) {
  const std::vector<Box<double>>& boxes = tree.levels[level - 1];
  const std::size_t first = index * SurfaceTree::branching;
  const std::size_t end = std::min(first + SurfaceTree::branching, boxes.size());
  NearestChildren sorted;
  for (std::size_t i = first; i < end; ++i) {
    const double distance = squared_distance(boxes[i], point);
    if (distance > max) continue;
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
  tree.order = along_curve(surfaces);
  tree.levels.push_back(boxes_over(tree.order.size(), SurfaceTree::leaf_size,
                                   [&](std::size_t i) { return box_of(surfaces, tree.order[i]); }));
  while (tree.levels.back().size() > 1) {
    const std::vector<Box<double>>& below = tree.levels.back();
    tree.levels.push_back(boxes_over(below.size(), SurfaceTree::branching, [&](std::size_t i) { return below[i]; }));
  }
  tree.size = glm::length(tree.levels.back().front().size());
  return tree;
}

}  // namespace pomona
