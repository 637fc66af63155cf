// The side of a surface that is nearest to a point. Its colour is the limit of positive mean values at the surface, and
// the result where no surface is visible in any direction.
#pragma once

#include <limits>
#include <optional>

#include "generator/diffusion/surface_tree.h"

namespace pomona {

/// A point on one side of a triangle.
struct SurfaceSide {
  std::uint32_t triangle = 0;
  SideOf side = SideOf::front;
  glm::dvec3 barycentric{0};  ///< barycentric coordinates of the nearest place on the triangle
  double distance = 0;        ///< metres
};

/// The nearest side within `radius` (metres), if there is any. If several triangles are equally near (at a shared edge
/// or corner), it is the one whose normal is most parallel to the direction of the point, then the one with the
/// smallest index. A point in the plane of its triangle gets the front.
std::optional<SurfaceSide> nearest_side(const DiffusionSurfaces& surfaces, const SurfaceTree& tree,
                                        const glm::dvec3& point,
                                        double radius = std::numeric_limits<double>::infinity());

/// The colour there, linear.
glm::dvec3 color_of(const DiffusionSurfaces& surfaces, const SurfaceSide& at);

/// The part of that side, an index into part_names.
std::int32_t part_of(const DiffusionSurfaces& surfaces, const SurfaceSide& at);

}  // namespace pomona
