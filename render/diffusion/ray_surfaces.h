// Diffusion surfaces as the compute shader reads them: normalised, in a tree of boxes, by storage buffer.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "generator/diffusion/surface_tree.h"
#include "render/diffusion/ray_tree.h"

namespace pomona {

/// What the numbers on the card mean. The middle of the surfaces is 0, and a power of two brings them into [-1, 1].
struct RayFrame {
  glm::dvec3 middle{0};                  ///< metres
  double scale = 1;                      ///< normalised lengths per metre
  std::vector<std::int32_t> used_parts;  ///< ascending; index into part_names

  glm::vec3 normalized(const glm::vec3& point) const;
};

/// \throws Error (bad_data) if more than 1024 parts are used.
RayFrame ray_frame(const DiffusionSurfaces& surfaces, const SurfaceTree& tree);

/// Corners x, y, z, and the vertex that each is.
struct RayTriangle {
  glm::uvec4 corner[3];
};

/// The arrays of one fruit.
struct RaySurfaces {
  std::vector<RayNode> node;
  std::vector<RayTriangle> triangle;  ///< leaf by leaf
  std::vector<glm::uvec2> side;       ///< by triangle: its index in the surfaces; front part + 65536 * back part
  std::vector<glm::vec4> color;       ///< front and back of each vertex
};

RaySurfaces ray_surfaces(const DiffusionSurfaces& surfaces, const SurfaceTree& tree, const RayFrame& frame);

}  // namespace pomona
