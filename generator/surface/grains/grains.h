// Grains: small closed shapes scattered over a swept surface by dart throwing (paper, section 4, step 2).
#pragma once

#include "generator/base/random.h"
#include "generator/surface/sweep/sweep.h"

namespace pomona {

/// The grains alone, one surface per GrainSketch, to be joined() to the swept surfaces.
/// No two centres of one sketch whose normals agree are nearer than its Poisson radius.
/// More detail than 1 gives them finer triangles, and leaves them where they are.
/// \throws Error (bad_data) for a radius below 1/1000 of the fruit, more than 20 000 grains, or 16 million vertices.
DiffusionSurfaces scatter_grains(const Template& fruit, VariantKey key, const SweepOptions& options = {});

}  // namespace pomona
