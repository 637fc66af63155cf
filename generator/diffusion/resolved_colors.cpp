#include "generator/diffusion/resolved_colors.h"

#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include <glm/common.hpp>

#include "generator/base/error.h"

namespace pomona {

namespace {

/// A point nearer than this to a surface, in parts of the surfaces' size, is on it.
constexpr double on_surface = 1e-5;

}  // namespace

ColorHull hull_of(const DiffusionSurfaces& surfaces, const SurfaceTree& tree) {
  const glm::uvec3& any = surfaces.triangle[tree.order.front()];
  ColorHull hull{surfaces.front_color[any.x], surfaces.front_color[any.x]};
  for (const std::uint32_t triangle : tree.order) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = surfaces.triangle[triangle][k];
      const Color &front = surfaces.front_color[vertex], &back = surfaces.back_color[vertex];
      hull.low = glm::min(hull.low, glm::min(front, back));
      hull.high = glm::max(hull.high, glm::max(front, back));
    }
  }
  return hull;
}

void require_finite(std::span<const glm::vec3> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::isfinite(points[i].x) && std::isfinite(points[i].y) && std::isfinite(points[i].z)) continue;
    throw Error(ExitStatus::bad_data, "diffusion: point " + std::to_string(i) + " has a coordinate that is not finite");
  }
}

SidesOfPoints sides_on_surfaces(const DiffusionSurfaces& surfaces, const SurfaceTree& tree,
                                std::span<const glm::vec3> points, Threads threads) {
  SidesOfPoints sides(points.size());
  parallel_for(points.size(), threads, [&](std::size_t i) {
    sides[i] = nearest_side(surfaces, tree, glm::dvec3(points[i]), on_surface * tree.size);
  });
  return sides;
}

SidesOfPoints sides_on_surfaces(const DiffusionSurfaces& surfaces, const SurfaceTree& tree,
                                std::span<const glm::vec3> points, std::span<const std::uint8_t> near_surface,
                                Threads threads) {
  std::vector<std::uint32_t> near;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (near_surface[i] != 0) near.push_back(i);
  }
  SidesOfPoints sides(points.size());
  parallel_for(near.size(), threads, [&](std::size_t i) {
    sides[near[i]] = nearest_side(surfaces, tree, glm::dvec3(points[near[i]]), on_surface * tree.size);
  });
  return sides;
}

SidesOfPoints sides_where_known(const DiffusionSurfaces& surfaces, const SurfaceTree& tree,
                                std::span<const glm::vec3> points, SidesOfPoints sides,
                                std::span<const PmvcValue> values, Threads threads) {
  constexpr double anywhere = std::numeric_limits<double>::infinity();
  parallel_for(points.size(), threads, [&](std::size_t i) {
    const bool sees_nothing = !sides[i] && !(values[i].weight > 0);
    if (sees_nothing) sides[i] = nearest_side(surfaces, tree, glm::dvec3(points[i]), anywhere);
  });
  return sides;
}

DiffusedColors resolved_colors(const DiffusionSurfaces& surfaces, const ColorHull& hull, const SidesOfPoints& known,
                               std::span<const PmvcValue> values, Threads threads) {
  DiffusedColors colors{std::vector<Color>(known.size()), std::vector<std::int32_t>(known.size())};
  parallel_for(known.size(), threads, [&](std::size_t i) {
    const Color color(known[i] ? color_of(surfaces, *known[i]) : values[i].color);
    colors.color[i] = glm::clamp(color, hull.low, hull.high);
    colors.part[i] = known[i] ? part_of(surfaces, *known[i]) : values[i].part;
  });
  return colors;
}

DiffusedColors resolved_colors(const DiffusionSurfaces& surfaces, const SurfaceTree& tree, const ColorHull& hull,
                               std::span<const glm::vec3> points, const SidesOfPoints& sides,
                               std::span<const PmvcValue> values, Threads threads) {
  return resolved_colors(surfaces, hull, sides_where_known(surfaces, tree, points, sides, values, threads), values,
                         threads);
}

DiffusedColors resolved_colors(const DiffusionSurfaces& surfaces, const SurfaceTree& tree, const ColorHull& hull,
                               std::span<const glm::vec3> points, std::span<const PmvcValue> values, Threads threads) {
  return resolved_colors(surfaces, tree, hull, points, sides_on_surfaces(surfaces, tree, points, threads), values,
                         threads);
}

}  // namespace pomona
