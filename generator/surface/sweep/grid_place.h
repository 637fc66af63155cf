// Points of a swept grid, by their position on the drawn curves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "generator/surface/sweep/swept_grid.h"

namespace pomona {

struct GridPoint {
  glm::dvec3 position{0};
  glm::dvec3 normal{0, 1, 0};  ///< unit, of the front
  glm::dvec3 uphill{1, 0, 0};  ///< unit, perpendicular to the normal: the direction in which `along` grows
};

/// Looks points of one grid up, which must outlive it; for grids around the axis.
class GridPlaces {
 public:
  explicit GridPlaces(const SweptGrid& grid);

  /// The point at a share of the vertical curve and an azimuth, radians. Beyond an open rim, the nearest point.
  GridPoint at(double along, double azimuth) const;

 private:
  struct Found;
  static constexpr std::size_t bins = 256;
  Found found_among(const std::vector<std::uint32_t>& triangles, double along, double turn) const;

  const SweptGrid& grid_;
  std::vector<glm::dvec3> normals_;
  std::vector<std::vector<std::uint32_t>> over_;  ///< triangles by the stretches of the vertical curve that they meet
};

/// The same for a single point.
GridPoint point_at(const SweptGrid& grid, double along, double azimuth);

/// The normal of the front at every vertex: the sum of its triangles' normals, each with a length of twice the area.
std::vector<glm::dvec3> summed_normals(const SweptGrid& grid);

/// The same with length 1; 0 where the sum is 0.
std::vector<glm::dvec3> unit_normals(const SweptGrid& grid);

/// The unit vector across `normal` that is nearest to `wanted`; any where none is nearer.
glm::dvec3 unit_across(const glm::dvec3& wanted, const glm::dvec3& normal);

/// The direction in which `along` grows in a triangle, of any length.
glm::dvec3 uphill(const SweptGrid& grid, const glm::uvec3& triangle);

}  // namespace pomona
