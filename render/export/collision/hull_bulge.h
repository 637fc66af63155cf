// How far a hull stands out of what it is the hull of.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/knife/knife.h"
#include "render/export/collision/cut_surface.h"
#include "render/export/convex_hull.h"

namespace pomona::collision {

/// A face of a hull as a plane, its normal outward and of length 1.
struct FacePlane {
  glm::dvec3 normal;
  double offset = 0;  ///< metres
};

std::vector<FacePlane> faces_of(const ConvexHull& hull);

/// How deep a point lies in the hull of these faces, metres; negative outside, where it is no distance.
double depth_in(const std::vector<FacePlane>& faces, const glm::dvec3& point);

/// Where a hull stands out of its surface farthest, seen from the middle of a triangle: the plane there touches the
/// surface.
struct Bulge {
  double way = 0;  ///< metres
  std::size_t triangle = 0;
  CuttingPlane plane;
};

/// \param least way that counts, metres. \param given_up triangles that are passed over.
std::optional<Bulge> largest_bulge(const ConvexHull& hull, const CutSurface& surface, double least,
                                   const std::vector<char>& given_up);

}  // namespace pomona::collision
