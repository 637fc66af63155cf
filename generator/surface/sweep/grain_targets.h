// Where on a swept surface grains may grow, and how densely.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "generator/base/random.h"
#include "generator/surface/sweep/swept_grid.h"

namespace pomona {

/// A point of a surface as its grains see it.
struct GrainPlace {
  glm::dvec3 position{0};
  glm::dvec3 normal{0};                     ///< of the front, any length
  double along = 0, around = 0, depth = 0;  ///< as in SweptGrid; around goes on beyond 1 where a triangle does
};

/// share_a * a + share_b * b.
GrainPlace blend(const GrainPlace& a, double share_a, const GrainPlace& b, double share_b);

/// A triangle where grains may grow, or a piece of one.
struct GrainTarget {
  std::array<GrainPlace, 3> corner;
  glm::dvec3 uphill{0};  ///< the way `along` grows
  double most = 1;       ///< no less than the density at any place
};

double area_of(const GrainTarget& target);

/// The triangles in reach of the sketch's band, in its folds; `random` draws which folds stay empty.
std::vector<GrainTarget> grain_targets(std::span<const SweptGrid> grids, const GrainSketch& sketch,
                                       const RandomStream& random);

/// The density at a place of a target, 0..1; 0 outside the sketch's limits, and where it is below 0.01.
double density_at(const GrainSketch& sketch, const GrainPlace& place);

/// An upper bound for it all over a target.
double most_density(const GrainSketch& sketch, const GrainTarget& target);

}  // namespace pomona
