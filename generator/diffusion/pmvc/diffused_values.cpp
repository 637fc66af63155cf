#include "generator/diffusion/pmvc/diffused_values.h"

#include <algorithm>

#include "generator/diffusion/pmvc/line_pmvc.h"
#include "generator/diffusion/pmvc/relaxed_lines.h"
#include "generator/diffusion/pmvc/values_off_surfaces.h"
#include "generator/diffusion/resolved_colors.h"

namespace pomona {

namespace {

/// The least and the greatest fourth value of the triangles' corners.
struct Limits {
  float low = 0, high = 0;
};

Limits limits_of(const DiffusionSurfaces& surfaces, const SurfaceTree& tree, std::span<const float> value) {
  const float any = value[surfaces.triangle[tree.order.front()].x];
  Limits limits{any, any};
  for (const std::uint32_t triangle : tree.order) {
    for (int k = 0; k < 3; ++k) {
      const float v = value[surfaces.triangle[triangle][k]];
      limits.low = std::min(limits.low, v), limits.high = std::max(limits.high, v);
    }
  }
  return limits;
}

double value_at(const DiffusionSurfaces& surfaces, const SurfaceSide& at, std::span<const float> value) {
  const glm::uvec3& t = surfaces.triangle[at.triangle];
  return at.barycentric.x * static_cast<double>(value[t.x]) + at.barycentric.y * static_cast<double>(value[t.y]) +
         at.barycentric.z * static_cast<double>(value[t.z]);
}

}  // namespace

std::vector<glm::vec4> diffused_values(DiffusionSurfaces surfaces, std::span<const glm::vec4> value,
                                       std::span<const glm::vec3> points, Threads threads) {
  // The first three channels are diffused as colours, the fourth beside them.
  std::vector<float> fourth;
  for (std::size_t v = 0; v < value.size(); ++v) {
    surfaces.front_color[v] = surfaces.back_color[v] = glm::vec3(value[v]);
    fourth.push_back(value[v].w);
  }
  require_finite(points);
  const SurfaceTree tree = make_surface_tree(surfaces);
  const SidesOfPoints sides = sides_on_surfaces(surfaces, tree, points, threads);
  const std::vector<PmvcValue> values = values_off_surfaces(sides, points, [&](std::span<const glm::vec3> off) {
    return line_pmvc(surfaces, tree, off, {.lines = relaxed_draft_lines(), .more = {}, .follow_plane = false}, threads,
                     fourth);
  });

  const SidesOfPoints known = sides_where_known(surfaces, tree, points, sides, values, threads);
  const DiffusedColors colors = resolved_colors(surfaces, hull_of(surfaces, tree), known, values, threads);
  const Limits limits = limits_of(surfaces, tree, fourth);
  std::vector<glm::vec4> diffused;
  diffused.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double w = known[i] ? value_at(surfaces, *known[i], fourth) : values[i].fourth;
    diffused.emplace_back(colors.color[i], std::clamp(static_cast<float>(w), limits.low, limits.high));
  }
  return diffused;
}

}  // namespace pomona
