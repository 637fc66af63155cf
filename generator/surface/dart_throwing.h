// Places for grains, by dart throwing [Cook 1986; paper, section 4, step 2].
#pragma once

#include <span>
#include <vector>

#include "generator/base/random.h"
#include "generator/surface/swept_grid.h"

namespace pomona {

/// Where one grain sits.
struct Dart {
  glm::dvec3 center{0};
  glm::dvec3 normal{0};      ///< unit, away from the side the grain sits on
  glm::dvec3 tangent{0};     ///< unit, across the normal, along the vertical curve
  std::uint64_t number = 0;  ///< of the candidate: what further draws are keyed by
};

/// A stream's draws belong to candidates, so many to each.
constexpr std::uint64_t draws_per_candidate = 8;

/// Area of the triangles that reach into the sketch's band.
double band_area(std::span<const SweptGrid> grids, const GrainSketch& sketch);

/// Candidates spread evenly over the band are taken one by one; each stays unless an earlier one that faces the
/// same way has its centre nearer than the Poisson radius. Uses draws 0 to 2 of each candidate.
std::vector<Dart> thrown_darts(std::span<const SweptGrid> grids, const GrainSketch& sketch, const RandomStream& random);

}  // namespace pomona
