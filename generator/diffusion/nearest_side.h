// The side of a surface that lies nearest to a point: the limit of positive mean values at a surface, and
// the answer where no direction sees anything.
#pragma once

#include <limits>
#include <optional>

#include "generator/diffusion/surface_tree.h"

namespace pomona {

/// A point on one side of a triangle.
struct SurfaceSide {
  std::uint32_t triangle = 0;
  SideOf side = SideOf::front;
  glm::dvec3 barycentric{0};  ///< of the nearest place on the triangle
  double distance = 0;        ///< metres
};

/// The nearest side within `radius` (metres), if there is any. Where several triangles are equally near (a
/// shared edge or corner), the one faced most squarely wins, then the smallest index; a point in the plane of
/// its triangle takes the front.
std::optional<SurfaceSide> nearest_side(const DiffusionSurfaces& surfaces, const SurfaceTree& tree,
                                        const glm::dvec3& point,
                                        double radius = std::numeric_limits<double>::infinity());

/// The colour there, linear.
glm::dvec3 color_of(const DiffusionSurfaces& surfaces, const SurfaceSide& at);

/// The part of that side, an index into part_names.
std::int32_t part_of(const DiffusionSurfaces& surfaces, const SurfaceSide& at);

}  // namespace pomona
