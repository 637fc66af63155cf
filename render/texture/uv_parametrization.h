// UV parametrization: laying a region of a surface flat with little stretch.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace pomona {

/// A patch of surface: triangles of points in space.
struct Patch3 {
  std::vector<glm::dvec3> point;
  std::vector<glm::uvec3> triangle;
};

/// How lengths change on the way to the plane: of the two principal stretches s >= t of each triangle (1 where
/// nothing changes) the mean of max(s, 1 / t), by area, and the worst. Triangles narrower than a
/// ten-thousandth of the patch are left out: less than a texel of any texture, they show nothing.
struct Stretch {
  double mean = 1;
  double worst = 1;
  double area = 0;  ///< of the triangles that count, square metres
};
Stretch stretch_of(const Patch3& patch, std::span<const glm::dvec2> flat);

/// A place in the plane for each point, starting from `projected` (every triangle counter-clockwise), moved so that
/// every triangle keeps its shape and size as nearly as it can: as-rigid-as-possible [Liu et al. 2008], by
/// successive over-relaxation in a fixed order. No triangle turns over.
std::vector<glm::dvec2> relaxed(const Patch3& patch, std::vector<glm::dvec2> projected);

/// Triangles that lie, in the plane, on another one they share no corner with.
std::vector<std::uint32_t> overlapping(std::span<const glm::uvec3> triangles, std::span<const glm::dvec2> flat);

}  // namespace pomona
