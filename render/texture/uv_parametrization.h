// Flattens a region of a surface with little stretch.
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

/// The change of lengths by flattening. Each triangle has two principal stretches s >= t (1 = no change); this is the
/// mean of max(s, 1 / t), weighted by area, and the worst. Triangles narrower than a ten-thousandth of the patch are
/// ignored: they are smaller than a texel of any texture.
struct Stretch {
  double mean = 1;
  double worst = 1;
  double area = 0;  ///< area of the triangles that count, square metres
};
Stretch stretch_of(const Patch3& patch, std::span<const glm::dvec2> flat);

/// A position in the plane for each point. It starts from `projected` (every triangle counter-clockwise), and moves
/// points so that every triangle keeps its shape and size as well as possible: as-rigid-as-possible [Liu et al. 2008],
/// by successive over-relaxation in a fixed order. No triangle turns over.
std::vector<glm::dvec2> relaxed(const Patch3& patch, std::vector<glm::dvec2> projected);

/// The triangles that overlap, in the plane, another triangle with which they share no corner.
std::vector<std::uint32_t> overlapping(std::span<const glm::uvec3> triangles, std::span<const glm::dvec2> flat);

}  // namespace pomona
