// The end of a walk: the side of a surface next to it.
#pragma once

#include "generator/diffusion/nearest_side.h"
#include "generator/diffusion/walk/empty_balls.h"

namespace pomona {

/// The nearest side of a surface to a point (normalised as `balls`) nearer than 1e-3 to one. Of equally near triangles,
/// at a shared edge or corner, it is a side that the point sees.
SurfaceSide side_next_to(const DiffusionSurfaces& surfaces, const EmptyBalls& balls, const glm::dvec3& point);

}  // namespace pomona
