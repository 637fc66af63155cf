// Diffusion surfaces as the compute shader reads them: normalised, in a tree of boxes, by storage buffer.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "generator/diffusion/surface_tree.h"

namespace pomona {

/// Two boxes and what is in them. Floats are kept as their bits, so that no driver takes an index for a number.
struct RayNode {
  glm::uvec4 low0{0}, high0{0}, low1{0}, high1{0};  ///< corners; low.w = child: >= 0 a node, < 0 ~(8 * first + count)
};

/// Corners x, y, z, and the vertex that each is.
struct RayTriangle {
  glm::uvec4 corner[3];
};

/// One fruit. The middle of the surfaces is 0, and a power of two brings them into [-1, 1].
struct RaySurfaces {
  static constexpr int max_depth = 32;  ///< limit of the tree's depth, which is the number of waiting nodes; see
                                        ///< pmvc_rays.comp.glsl

  std::vector<RayNode> node;          ///< the first is the root
  std::vector<RayTriangle> triangle;  ///< leaf by leaf
  std::vector<glm::uvec2> side;       ///< by triangle: its index in the surfaces; front part + 65536 * back part
  std::vector<glm::vec4> color;       ///< front and back of each vertex

  std::vector<std::int32_t> used_parts;  ///< ascending; index into part_names
  glm::dvec3 middle{0};                  ///< metres
  double scale = 1;                      ///< normalised lengths per metre

  glm::vec3 normalized(const glm::vec3& point) const;
};

/// Splits boxes where their surface area promises least work [Wald, "On fast construction of SAH-based bounding
/// volume hierarchies", 2007].
/// \throws Error (bad_data) if more than 1024 parts are used.
RaySurfaces ray_surfaces(const DiffusionSurfaces& surfaces, const SurfaceTree& tree);

}  // namespace pomona
