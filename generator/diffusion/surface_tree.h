// A bounding volume hierarchy of the surfaces, to find triangles near a point or visible from it.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/mesh/box.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// The triangle's corners, metres.
std::array<glm::dvec3, 3> corners(const DiffusionSurfaces& surfaces, std::uint32_t triangle);

/// A tree over all triangles of some area, sorted along a Morton curve so that neighbours in `order` are
/// neighbours in space. Leaf i holds order[leaf_size * i ...]; box i of level k + 1 holds the boxes
/// [branching * i, branching * (i + 1)) of level k; the last level is one box.
struct SurfaceTree {
  static constexpr std::size_t leaf_size = 16;
  static constexpr std::size_t branching = 8;

  std::vector<std::uint32_t> order;
  std::vector<std::vector<Box<double>>> levels;  ///< exact: their corners are coordinates of vertices
  double size = 0;                               ///< diagonal of the box around all, metres
};

/// The boxes of `level` - 1 inside box `index` of `level` (> 0), nearest to a point first, with their squared
/// distances; none farther than `max`, squared too.
struct NearestChildren {
  std::array<std::pair<double, std::size_t>, SurfaceTree::branching> child;
  std::size_t count = 0;
};
NearestChildren nearest_children(const SurfaceTree& tree, std::size_t level, std::size_t index, const glm::dvec3& point,
                                 double max = std::numeric_limits<double>::infinity());

/// The range of `order` in leaf `index`: first and end.
std::pair<std::size_t, std::size_t> leaf(const SurfaceTree& tree, std::size_t index);

/// \throws Error (bad_data) if a coordinate or a colour is not finite, or no triangle has any area.
SurfaceTree make_surface_tree(const DiffusionSurfaces& surfaces);

}  // namespace pomona
