// The parts of a swept surface where grains may grow, and their density.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "generator/base/random.h"
#include "generator/surface/sweep/swept_grid.h"

namespace pomona {

/// A point of a surface, with the attributes that grains need.
struct GrainPlace {
  glm::dvec3 position{0};
  glm::dvec3 normal{0};                     ///< normal of the front, any length
  double along = 0, around = 0, depth = 0;  ///< as in SweptGrid; around goes on beyond 1 where a triangle does
};

/// share_a * a + share_b * b.
GrainPlace blend(const GrainPlace& a, double share_a, const GrainPlace& b, double share_b);

/// A triangle where grains may grow, or a piece of one.
struct GrainTarget {
  std::array<GrainPlace, 3> corner;
  glm::dvec3 uphill{0};  ///< the direction in which `along` grows
  double max = 1;        ///< upper bound of the density in the triangle
};

double area_of(const GrainTarget& target);

/// The triangles within the sketch's band, in its folds. `random` decides which folds stay empty.
std::vector<GrainTarget> grain_targets(std::span<const SweptGrid> grids, const GrainSketch& sketch,
                                       const RandomStream& random);

/// The density at a point of a target, 0..1; 0 outside the sketch's limits, and where it would be below 0.01.
double density_at(const GrainSketch& sketch, const GrainPlace& place);

/// An upper bound of the density in a target.
double max_density(const GrainSketch& sketch, const GrainTarget& target);

}  // namespace pomona
