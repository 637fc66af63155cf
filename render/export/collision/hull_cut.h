// Hulls cut by planes.
#pragma once

#include <cstddef>
#include <span>

#include <glm/vec3.hpp>

#include "generator/knife/knife.h"
#include "render/export/convex_hull.h"

namespace pomona {

/// The volume of a hull, cubic metres.
double volume_of(const ConvexHull& hull);

/// The volume of what a plane cuts off, in front of it.
/// \param corners of the hull, wherever it stands
double volume_before(std::span<const glm::dvec3> corners, std::span<const glm::uvec3> triangles,
                     const CuttingPlane& plane);

/// What of the hull lies behind the plane. \param most corners, at least 14
ConvexHull behind(const ConvexHull& hull, const CuttingPlane& plane, std::size_t most);

}  // namespace pomona
