// Points of a swept grid by where they lie on the drawn curves.
#pragma once

#include <vector>

#include "generator/surface/sweep/swept_grid.h"

namespace pomona {

struct GridPoint {
  glm::dvec3 position{0};
  glm::dvec3 normal{0, 1, 0};  ///< unit, of the front
  glm::dvec3 uphill{1, 0, 0};  ///< unit, across the normal: the way `along` grows
};

/// The point at a share of the vertical curve and an azimuth, radians; for grids around the axis. Beside an open
/// rim, the nearest there is.
GridPoint point_at(const SweptGrid& grid, double along, double azimuth);

/// Of the front at every vertex: the sum of its triangles' normals, each as long as twice their area.
std::vector<glm::dvec3> summed_normals(const SweptGrid& grid);

/// The same of unit length; 0 where no triangle says.
std::vector<glm::dvec3> unit_normals(const SweptGrid& grid);

/// The unit vector across `normal` that is nearest to `wanted`; any where none is nearer.
glm::dvec3 unit_across(const glm::dvec3& wanted, const glm::dvec3& normal);

/// The way `along` grows in a triangle, any length.
glm::dvec3 uphill(const SweptGrid& grid, const glm::uvec3& triangle);

}  // namespace pomona
