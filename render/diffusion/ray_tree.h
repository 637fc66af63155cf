// A binary tree of boxes over triangles, for rays.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace pomona {

/// Two boxes and what is in them. Floats are kept as their bits, so that no driver takes an index for a number.
struct RayNode {
  glm::uvec4 low0{0}, high0{0}, low1{0}, high1{0};  ///< corners; low.w = child: >= 0 a node, < 0 ~(8 * first + count)
};

struct RayTree {
  static constexpr int max_depth = 32;  ///< size of the stack of nodes; see pmvc_rays.comp.glsl

  std::vector<RayNode> node;         ///< the first is the root
  std::vector<std::uint32_t> order;  ///< the triangles, leaf by leaf
};

/// Splits boxes by the surface area heuristic [Wald, "On fast construction of SAH-based bounding
/// volume hierarchies", 2007]. Two triangles that share an edge and follow each other, as the halves of a sweep's
/// quadrangles do, stay together, which halves the work.
/// \param position  in [-1, 1]
/// \param chosen    of the triangles, the ones to take, ascending; at least one
RayTree make_ray_tree(std::span<const glm::vec3> position, std::span<const glm::uvec3> triangle,
                      std::span<const std::uint32_t> chosen);

}  // namespace pomona
